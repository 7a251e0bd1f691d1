#include "postproc/accept/apply_baseline.h"

#include <gtest/gtest.h>

#include "postproc/accept/accepted.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"

namespace gouge::apply_baseline_test {
namespace {

/// The small report, whose finding 2 (moves 1 and 2, up to 0.3333 mm) is accepted.
struct Accepted : SmallReport {
  std::vector<Acceptance> entries;

  Accepted() {
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      path.moves[i].end.tip = Vec3(static_cast<double>(i * i), 0, 0);  // no two motions are alike
      path.moves[i].has_start = i > 0;
    }
    model.tools[0].identity = "ball 10";
    const StoredResult stored = *read_result("r.json", write_json(model));
    entries = {*accept_finding(stored, 2, {"reason", "by", "2026-11-23"})};
  }
  [[nodiscard]] BaselineFacts apply() const { return apply_baseline("a.json", entries, model); }
  /// That nothing is accepted, and why.
  void expect_refused(const std::string& why) const {
    const BaselineFacts facts = apply();
    EXPECT_EQ(facts.accepted_findings(), 0U);
    EXPECT_EQ(facts.accepted_moves, 0U);
    EXPECT_EQ(facts.entries.at(0).use, BaselineEntry::Use::voided);
    EXPECT_NE(facts.entries.at(0).why.find(why), std::string::npos) << facts.entries.at(0).why;
  }
};

TEST(ApplyBaseline, TheSameResultIsAcceptedAndNothingElse) {
  const Accepted report;
  const BaselineFacts facts = report.apply();
  ASSERT_EQ(facts.events.size(), 3U);
  EXPECT_TRUE(facts.is_accepted(0));
  EXPECT_FALSE(facts.is_accepted(1)) << "a near miss";
  EXPECT_FALSE(facts.is_accepted(2)) << "a buried tool";
  EXPECT_EQ(facts.accepted_moves, 2U);
  EXPECT_EQ(facts.entries.at(0).use, BaselineEntry::Use::applied);
}

TEST(ApplyBaseline, DeeperIsNot) {
  Accepted report;
  report.set_gouge(2, 0.3338);  // as deep as was certified
  EXPECT_EQ(report.apply().accepted_findings(), 1U);
  report.set_gouge(2, 0.3339);
  report.expect_refused("accepted up to 0.334 mm");
}

TEST(ApplyBaseline, LessCertainIsNot) {
  Accepted report;
  report.result.verdicts[2].depth_upper_mm = 0.3338 + 0.001;
  EXPECT_EQ(report.apply().accepted_findings(), 1U);
  report.result.verdicts[2].depth_upper_mm = 0.3338 + 0.0011;
  report.expect_refused("certified to");
}

TEST(ApplyBaseline, WiderIsNot) {
  Accepted report;
  report.set_gouge(3, 0.05);
  report.result.events[0].last_move = 3;
  report.result.events[0].moves = 3;
  report.result.events.erase(report.result.events.begin() + 1);
  report.expect_refused("line 13 was not accepted (2 of 3 moves accepted)");
}

TEST(ApplyBaseline, AnotherBodyCounterpartOrMotionIsNot) {
  Accepted body;
  body.result.verdicts[2].witness->body = Body::holder;
  body.result.events[0].body = Body::holder;
  EXPECT_EQ(body.apply().accepted_findings(), 0U);
  Accepted fixture;
  fixture.result.verdicts[2].witness->against = Against::fixture;
  EXPECT_EQ(fixture.apply().accepted_findings(), 0U);
  Accepted motion;
  motion.path.moves[2].end.tip.z() = 1e-9;
  EXPECT_EQ(motion.apply().accepted_findings(), 0U);
}

TEST(ApplyBaseline, AnotherMotionInTheSameLineVoids) {
  Accepted report;
  for (const std::size_t move : {1U, 2U, 3U}) report.path.moves[move].end.tip.z() = -0.1;
  report.set_gouge(2, 0.45);
  report.expect_refused("the motion in line 12 is another one: 0.450 mm deep, accepted up to 0.334 mm");
  const BaselineFacts facts = report.apply();
  EXPECT_NE(facts.events[0].why_not.find("another one"), std::string::npos);
  EXPECT_EQ(facts.events[0].entries, std::vector<std::size_t>{0});
}

TEST(ApplyBaseline, AnEntryOfAnotherProgramIsNotVoidBecauseItsLineGougesHere) {
  Accepted report;
  report.path.file = "other.apt";
  for (const std::size_t move : {1U, 2U, 3U}) report.path.moves[move].end.tip.z() = -0.1;
  report.set_gouge(2, 0.45);
  const BaselineFacts facts = report.apply();
  EXPECT_EQ(facts.entries[0].use, BaselineEntry::Use::elsewhere);
  EXPECT_EQ(facts.accepted_findings(), 0U);
  EXPECT_TRUE(facts.events[0].entries.empty());
}

TEST(ApplyBaseline, AnEntryOfAnotherProgramThatAcceptsAPartIsNotVoid) {
  Accepted report;
  report.entries[0].toolpath = "other.apt";
  report.entries[0].moves.pop_back();
  const BaselineFacts facts = report.apply();
  EXPECT_EQ(facts.entries[0].use, BaselineEntry::Use::partly);
  EXPECT_EQ(facts.entries[0].why, "it accepts 1 of 2 moves of the gouge in line 12");
  EXPECT_FALSE(facts.is_accepted(0));
  EXPECT_EQ(facts.events[0].why_not, "line 12 was not accepted (1 of 2 moves accepted)");
}

TEST(ApplyBaseline, AnotherToolOrSetUpVoids) {
  Accepted tool;
  tool.model.tools[0].identity = "ball 12";
  tool.expect_refused("T1 has other dimensions");
  Accepted tolerance;
  tolerance.model.options.tolerance_mm = 0.02;
  tolerance.expect_refused("the tolerance is 0.02 mm, 0.01 mm when it was accepted");
  Accepted part;
  part.model.inputs.push_back({"part", "part.stl", 1, "sha256:other"});
  part.expect_refused("the part is another one");
}

TEST(ApplyBaseline, AnEntryOfAnotherProgramThatConcernsNothingHereIsSetAside) {
  Accepted report;
  report.path.file = "other.apt";
  report.model.inputs.push_back({"part", "part.stl", 1, "sha256:other"});
  report.expect_refused("the part is another one");  // the same motions in another set-up
  for (Move& move : report.path.moves) move.end.tip.z() -= 1e-9;
  const BaselineEntry entry = report.apply().entries.at(0);
  EXPECT_EQ(entry.use, BaselineEntry::Use::elsewhere);
  EXPECT_EQ(entry.why, "");
}

TEST(ApplyBaseline, WhatIsOpenBesidesIsNot) {
  Accepted report;
  report.result.verdicts[2].reason = {Reason::Kind::of_path, Body::cutter, 0, std::string("the head is not known")};
  EXPECT_EQ(report.apply().accepted_findings(), 0U);
}

TEST(ApplyBaseline, WhatGougesNoMoreIsUnused) {
  Accepted report;
  report.result.verdicts[1] = report.result.verdicts[2] = MoveVerdict{};
  report.result.events.erase(report.result.events.begin());
  EXPECT_EQ(report.apply().entries.at(0).use, BaselineEntry::Use::unused);
}

}  // namespace
}  // namespace gouge::apply_baseline_test
