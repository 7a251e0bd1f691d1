#include "lib/path/assumption.h"

#include <gtest/gtest.h>

namespace gouge::assumption_test {
namespace {

Assumption fact(Subject subject, Basis basis, std::string object = {}) {
  Assumption made{.subject = subject, .object = std::move(object), .basis = basis, .value = "v"};
  made.evidence = "evidence";
  made.remedy = "remedy";
  made.code = "code";
  return made;
}

TEST(Assumption, OnlyContradictedAndUnknownFactsAreOpen) {
  for (const Basis basis : {Basis::stated, Basis::derived, Basis::by_default, Basis::contradicted, Basis::unknown}) {
    Assumptions facts = {fact(Subject::path_unit, basis)};
    settle(facts, {}, false);
    EXPECT_EQ(has_open(facts), basis == Basis::contradicted || basis == Basis::unknown) << basis_name(basis);
    settle(facts, {}, true);
    EXPECT_EQ(has_open(facts), basis != Basis::stated && basis != Basis::derived) << "strict, " << basis_name(basis);
  }
}

TEST(Assumption, VouchingForASubjectStatesItAndKeepsItsEvidence) {
  Assumptions facts = {fact(Subject::tool, Basis::contradicted, "T1"), fact(Subject::tool, Basis::contradicted, "T2"),
                       fact(Subject::completeness, Basis::unknown)};
  settle(facts, {{Subject::tool, "T2"}}, false);
  EXPECT_TRUE(facts[0].is_open) << "complete";
  EXPECT_TRUE(facts[1].is_open) << "T1";
  EXPECT_FALSE(facts[2].is_open);
  EXPECT_EQ(facts[2].basis, Basis::stated);
  EXPECT_EQ(facts[2].evidence, "evidence");
  settle(facts, {{Subject::tool, {}}, {Subject::completeness, {}}}, true);
  EXPECT_FALSE(has_open(facts));
}

TEST(Assumption, EveryNameReadsBackAndOthersDoNot) {
  for (std::size_t i = 0; i < kSubjects; ++i) {
    const auto subject = static_cast<Subject>(i);
    EXPECT_EQ(subject_called(subject_name(subject)), subject);
  }
  EXPECT_EQ(parse_vouched("tool=T3")->object, "T3");
  EXPECT_EQ(parse_vouched("placement")->object, "");
  for (const char* wrong : {"", "=", "tools", "tool=", "Tool", "path_unit"})
    EXPECT_FALSE(parse_vouched(wrong)) << wrong;
}

TEST(Assumption, AWarningHasTheEvidenceAndTheRemedyOfEachOpenFact) {
  Assumptions facts = {fact(Subject::placement, Basis::contradicted), fact(Subject::frame, Basis::by_default)};
  facts.front().file = "a.apt";
  settle(facts, {}, false);
  const Diagnostics warnings = open_warnings(facts);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(to_text(warnings.front()), "a.apt: warning: evidence; remedy [code]");
}

TEST(Assumption, TheLineOfAllFactsCountsThoseBeyondTheFourthOfASubject) {
  Assumptions facts = {fact(Subject::path_unit, Basis::stated)};
  for (int i = 1; i <= 6; ++i) facts.push_back(fact(Subject::tool, Basis::derived, "T" + std::to_string(i)));
  facts.push_back(fact(Subject::placement, Basis::by_default));
  settle(facts, {}, false);
  EXPECT_EQ(assumptions_text(facts),
            "path-unit v (stated), tool T1 v (derived), T2 v (derived), T3 v (derived), T4 v (derived) and 2 more, "
            "placement v (default)");
}

}  // namespace
}  // namespace gouge::assumption_test
