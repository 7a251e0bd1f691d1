#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Laws that admit several motions: `documented` and `any`, and the comparison of laws.

namespace gouge::testing_samples::machine_scopes_test {
namespace {

using Json = nlohmann::json;

const std::string kTrunnion = "preset:linuxcnc-xyzac-trt";

class Scopes : public testing::Test {
 protected:
  [[nodiscard]] Outcome check(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--json", "check.json", "--certificate", "proofs.gcp"});
    return run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath(), more));
  }
  [[nodiscard]] Outcome check_by(const std::string& law, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"--machine", kTrunnion, "--feed-law", law, "--rapid-law", law});
    return check(more);
  }
  [[nodiscard]] Outcome verify() const {
    return run_gougecheck(sample_.path, {"verify", "check.json", "--certificate", "proofs.gcp"});
  }
  [[nodiscard]] Json result() const { return Json::parse(text_of(sample_.path + "/check.json")); }
  /// The result with a text replaced must be refuted.
  void expect_refuted(const std::string& from, const std::string& to) const {
    std::string changed = text_of(sample_.path + "/check.json");
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_text(sample_.path + "/changed.json", changed.replace(at, from.size(), to));
    const Outcome ran = run_gougecheck(sample_.path, {"verify", "changed.json"});
    EXPECT_EQ(ran.exit_status, 1) << from << " " << ran.out << ran.err;
  }
  SampleFolder sample_ = open_sample("pole_crossing");
};

TEST_F(Scopes, DocumentedFindsTheGougeOfTheRotaryJointsAndProvesBothMotions) {
  EXPECT_EQ(check_by("vector").exit_status, 0);
  const Outcome ran = check_by("documented");
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  const Json move = result().at("moves").at(0);
  EXPECT_NEAR(move.at("depth"), 1, 1e-3);
  EXPECT_NEAR(move.at("witness").at("turn").at("first"), move.at("witness").at("t"), 1e-12);
  const Outcome verified = verify();
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  EXPECT_NE(verified.out.find("1 gouging move proved to be no deeper than said"), std::string::npos) << verified.out;
  EXPECT_NE(verified.out.find("1 move proved clean"), std::string::npos) << verified.out;
  expect_refuted("\"first\": 0.5", "\"first\": 0.4");
  expect_refuted("\"state\": \"gouge\",\n   \"depth\": 0.9", "\"state\": \"gouge\",\n   \"depth\": 0.8");
}

TEST_F(Scopes, AnyFindsTheGougeWithABoundThatCoversAllTurns) {
  const Outcome ran = check_by("any");
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  const Json move = result().at("moves").at(0);
  EXPECT_NEAR(move.at("depth"), 1, 1e-3);
  EXPECT_GE(move.at("depth_upper").get<double>(), 1 - 1e-9);
  EXPECT_LE(move.at("depth_upper").get<double>(), 1.1);
  EXPECT_TRUE(move.at("overcut").is_null());
  const Outcome verified = verify();
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
}

TEST_F(Scopes, AWitnessOutsideOfTheLawIsRefuted) {
  EXPECT_EQ(check_by("axis").exit_status, 1);
  expect_refuted("\"triangle\": ", "\"turn\": {\"first\": 0.5, \"second\": 0.5}, \"triangle\": ");
}

TEST_F(Scopes, AnyIsCleanWhereThePostIsOutOfReachOfAllTurns) {
  // The holder turns to 32 degrees of the post at most; 3 mm farther out nothing reaches it.
  const Outcome ran = check_by("any", {"--place", "3,0,0"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  const Outcome verified = verify();
  EXPECT_EQ(verified.exit_status, 4) << verified.out << verified.err;
  EXPECT_NE(verified.out.find("only sampled: 1 move said to be clean"), std::string::npos) << verified.out;
}

TEST_F(Scopes, AResultTellsWhichMovesDependOnTheLaw) {
  EXPECT_EQ(check_by("vector").exit_status, 0);
  EXPECT_EQ(result().at("any_turn").at("others"), 1);
  EXPECT_EQ(result().at("any_turn").at("proved_others"), 0);
  const Outcome far = check_by("vector", {"--place", "3,0,0"});
  EXPECT_EQ(far.exit_status, 0);
  EXPECT_EQ(result().at("any_turn").at("proved_others"), 1);
  EXPECT_NE(far.out.find("1 of 1 move is clean apart from the cutter, whatever the control does"), std::string::npos)
      << far.out;
  EXPECT_EQ(check({}).exit_status, 0);
  EXPECT_FALSE(result().contains("any_turn")) << "without a machine";
}

TEST_F(Scopes, AControlThatPromisesNoLawIsCheckedByBothDocumentedOnes) {
  const Outcome ran = check({"--machine", "preset:haas-umc750", "--rapid-law", "vector"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  const Json facts = result().at("assumptions");
  for (const Json& fact : facts) {
    if (fact.at("fact") != "motion-law") continue;
    EXPECT_EQ(fact.at("state"), "default");
    EXPECT_EQ(fact.at("value"), "documented of haas-umc750, rapids great-circle");
    EXPECT_NE(fact.at("evidence").get<std::string>().find("the control promises no law of motion"), std::string::npos);
  }
  EXPECT_EQ(check({"--machine", "preset:haas-umc750", "--rapid-law", "vector", "--strict", "--place", "3,0,0",
                   "--assume", "placement"})
                .exit_status,
            4)
      << "a default is not allowed";
}

TEST_F(Scopes, TheVerdictNamesTheMachineAndTheSmoothingOfItsControl) {
  const auto fact = [&](const std::string& name) {
    const Json all = result().at("assumptions");
    for (const Json& one : all)
      if (one.at("fact") == name) return one;
    return Json();
  };
  EXPECT_EQ(check_by("vector").exit_status, 0);
  EXPECT_EQ(fact("machine").at("value"), "linuxcnc-xyzac-trt");
  EXPECT_EQ(fact("machine").at("state"), "stated");
  EXPECT_EQ(fact("smoothing").at("state"), "default");
  EXPECT_EQ(fact("smoothing").at("value"), "none");
  EXPECT_EQ(check_by("vector", {"--tip-tolerance", "0.002", "--axis-tolerance", "0.01"}).exit_status, 0);
  EXPECT_EQ(fact("smoothing").at("state"), "stated");
  EXPECT_EQ(fact("smoothing").at("value"), "0.002 mm and 0.01 degrees");
  EXPECT_EQ(check_by("vector", {"--assume", "smoothing"}).exit_status, 0);
  EXPECT_EQ(fact("smoothing").at("state"), "stated");
  EXPECT_EQ(check({}).exit_status, 0);
  EXPECT_TRUE(fact("smoothing").is_null()) << "without a machine";
}

TEST_F(Scopes, LawsAreComparedWithDepthAndLine) {
  const Outcome ran = check_by("vector", {"--laws"});
  EXPECT_EQ(ran.exit_status, 0) << "the law of the control decides";
  for (const char* text :
       {"feeds by vector: no gouge", "feeds by axis: 1 move with a gouge, the deepest 1 mm at line 7",
        "feeds by joint: not checked, law joint"})
    EXPECT_NE(ran.out.find(text), std::string::npos) << text << "\n" << ran.out;
  EXPECT_EQ(ran.out.find("rapids by"), std::string::npos) << "the path has no rapids";
  const Json laws = result().at("laws");
  ASSERT_EQ(laws.size(), 3U);
  EXPECT_EQ(laws.at(1).at("gouges"), 1);
  EXPECT_EQ(laws.at(1).at("line"), 7);
  const Outcome points = check_by("vector", {"--laws", "--joint-point", "A=0,0,-50", "--joint-point", "C=0,0,-50"});
  EXPECT_NE(points.out.find("feeds by joint: "), std::string::npos) << points.out;
  EXPECT_EQ(points.out.find("feeds by joint: not checked"), std::string::npos) << points.out;
}

TEST_F(Scopes, ComparingLawsNeedsAMachine) {
  const Outcome ran = check({"--laws"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("--laws: expected --machine beside it"), std::string::npos) << ran.err;
}

TEST_F(Scopes, AResultHasTheSameBytesAtAnyNumberOfThreads) {
  for (const std::string law : {"vector", "documented", "any"}) {
    const Outcome ran = check_by(law, {"--threads", "1"});
    const std::string alone = text_of(sample_.path + "/check.json");
    const Outcome again = check_by(law, {"--threads", "2"});
    EXPECT_EQ(ran.out, again.out) << law;
    EXPECT_EQ(alone, text_of(sample_.path + "/check.json")) << law;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::machine_scopes_test
