#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/samples/box_stl.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"

// Facts of joints on the command line, in project files and in results, and motions that differ in their joints alone.

namespace gouge::testing_samples::joint_facts_test {
namespace {

using Json = nlohmann::json;

/// The sample rapid_joints, whose machine file lacks the points of its rotary joints.
class JointFacts : public testing::Test {
 protected:
  JointFacts() {
    std::string machine = text_of(sample_.path + "/machine.json");
    const std::string point = "\"point\": [0, 0, 0], ";
    machine.replace(machine.find(point), point.size(), "");
    machine.replace(machine.find(", \"point\": [0, 0, 0]"), point.size(), "");
    write_text(sample_.path + "/machine.json", machine);
  }

  [[nodiscard]] Outcome check(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"--machine", "machine.json", "--tool-length", "100"};
    words.insert(words.end(), more.begin(), more.end());
    return run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath(), words));
  }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(sample_.path + "/" + file)); }

  const std::vector<std::string> points_ = {"--joint-point", "C=0,0,0", "--joint-point", "B=0,0,0"};
  SampleFolder sample_ = open_sample("rapid_joints");
};

TEST_F(JointFacts, PointsOfTheCommandLineServeTheLawsOfAllJoints) {
  const Outcome open = check({});
  EXPECT_EQ(open.exit_status, 3);
  EXPECT_NE(open.err.find("or --joint-point C=X,Y,Z"), std::string::npos) << open.err;
  std::vector<std::string> words = points_;
  words.insert(words.end(), {"--json", "check.json"});
  EXPECT_EQ(check(words).exit_status, 1);
  const Json report = json_of("check.json");
  EXPECT_NEAR(report.at("moves").at(0).at("depth"), sample_.expected.at("by_machine").at(0).at("depth_max"), 2e-3);
  EXPECT_EQ(report.at("options").at("more").at("joint-point"), Json::array({"C=0,0,0", "B=0,0,0"}));
  for (const Json& fact : report.at("assumptions")) {
    if (fact.at("fact") != "motion-law") continue;
    EXPECT_NE(fact.at("evidence").get<std::string>().find("--joint-point B=0,0,0"), std::string::npos) << fact;
  }
}

TEST_F(JointFacts, AreRepeatedByAVerification) {
  std::vector<std::string> words = points_;
  words.insert(words.end(), {"--joint-limit", "B=-40..40", "--joint-rate", "B=3600", "--json", "check.json"});
  EXPECT_EQ(check(words).exit_status, 1);
  const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  std::string changed = text_of(sample_.path + "/check.json");
  const std::string point = "\"B=0,0,0\"";
  write_text(sample_.path + "/changed.json", changed.replace(changed.find(point), point.size(), "\"B=0,0,60\""));
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "changed.json"}).exit_status, 1);
}

TEST_F(JointFacts, ALimitOfTheCommandLineHolds) {
  std::vector<std::string> words = points_;
  words.insert(words.end(), {"--joint-limit", "B=-40..20", "--joint-limit", "C=-90..90"});
  const Outcome ran = check(words);
  EXPECT_EQ(ran.exit_status, 4) << ran.out;
  EXPECT_NE(ran.err.find("joint B would be at 30 degrees; its limit is 20 degrees"), std::string::npos) << ran.err;
}

TEST_F(JointFacts, ComeFromAProjectFileToo) {
  write_text(sample_.path + "/gougecheck.json",
             R"({"machine": "machine.json", "tool-length": 100, "joint-point": ["C=0,0,0", "B=0,0,0"]})");
  EXPECT_EQ(run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath())).exit_status, 1);
}

TEST_F(JointFacts, NeedAMachineAndAreShown) {
  const Outcome alone =
      run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath(), {"--joint-limit", "B=0..1"}));
  EXPECT_EQ(alone.exit_status, 2);
  EXPECT_NE(alone.err.find("--joint-limit B=0..1: expected --machine beside it"), std::string::npos) << alone.err;
  const Outcome shown = run_gougecheck(
      sample_.path, {"machine", "show", "machine.json", "--joint-limit", "B=-30..", "--joint-rate", "C=720"});
  EXPECT_EQ(shown.exit_status, 0) << shown.err;
  EXPECT_NE(shown.out.find("from -30 to ? deg"), std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("stated on the command line        --joint-rate C=720"), std::string::npos) << shown.out;
}

TEST_F(JointFacts, LimitTheJointsOfAPath) {
  const std::vector<std::string> words = {
      "path",  "joints", sample_.toolpath(), "--machine", "machine.json",  "--tool-length", "100",
      "--csv", "-",      "--joint-limit",    "B=..0",     "--joint-limit", "C=0..200"};
  const Outcome ran = run_gougecheck(sample_.path, words);
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_NE(ran.out.find(",180.000000,"), std::string::npos) << "C by half a turn instead: " << ran.out;
}

/// The sample rapid_joints as it is, with intervals.
class Intervals : public testing::Test {
 protected:
  [[nodiscard]] Outcome check(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"--machine", "machine.json", "--json", "check.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath(), words));
  }
  [[nodiscard]] double depth_with(const std::vector<std::string>& more) const {
    const Outcome ran = check(more);
    EXPECT_EQ(ran.exit_status, 1) << ran.err;
    return Json::parse(text_of(sample_.path + "/check.json")).at("moves").at(0).at("depth");
  }
  void expect_verified() const {
    const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json"});
    EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  }

  SampleFolder sample_ = open_sample("rapid_joints");
};

TEST_F(Intervals, OfTheToolLengthAddToTheTipTolerance) {
  const double depth = depth_with({"--tool-length", "100"});
  // Half of the interval, for a control that knows the length twice.
  EXPECT_NEAR(depth_with({"--tool-length", "99.95..100.05"}), depth + 0.1, 2e-3);
  expect_verified();
  const std::string text = text_of(sample_.path + "/check.json");
  EXPECT_NE(text.find("--tool-length 99.95..100.05 mm"), std::string::npos);
  EXPECT_NE(text.find("with 0.1 mm of tip tolerance for intervals"), std::string::npos);
  EXPECT_NEAR(depth_with({"--tool-length", "99.95..100.05", "--tip-tolerance", "0.2"}), depth + 0.3, 2e-3);
  expect_verified();
  EXPECT_EQ(check({"--tool-length", "100..99"}).exit_status, 2);
  const Outcome head = check({"--tool-length", "99.95..100.05", "--head", "part.stl"});
  EXPECT_EQ(head.exit_status, 2);
  EXPECT_NE(head.err.find("not the bodies of --head"), std::string::npos) << head.err;
}

TEST_F(Intervals, OfPointsAddToTheTipTolerance) {
  const double depth = depth_with({"--tool-length", "100"});
  std::string machine = text_of(sample_.path + "/machine.json");
  const std::string point = "\"direction\": [0, 1, 0], \"point\": [0, 0, 0]";
  ASSERT_NE(machine.find(point), std::string::npos);
  machine.replace(machine.find(point), point.size(), "\"direction\": [0, 1, 0], \"point\": [0, 0, [-0.02, 0.02]]");
  write_text(sample_.path + "/machine.json", machine);
  EXPECT_NEAR(depth_with({"--tool-length", "100"}), depth + 0.08, 2e-3);
  expect_verified();
  const Outcome shown = run_gougecheck(sample_.path, {"machine", "show", "machine.json"});
  EXPECT_NE(shown.out.find("through (0, 0, 0) mm, to within 0.02 mm"), std::string::npos) << shown.out;
}

/// A table whose joint C turns back at 350 degrees, and two posts beside the tool. The deeper gouge is in the first.
class TurnedTable : public testing::Test {
 protected:
  TurnedTable() {
    shop_.write("machine.json", R"({"name": "table", "source": "test", "unit": "mm", "joints": [
      {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "min": -10.001, "max": 350.5},
      {"name": "A", "type": "rotary", "side": "table", "direction": [0, 1, 0], "point": [0, 0, 0], "min": 0, "max": 100},
      {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
      {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
      {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
      "control": {"name": "c", "feed_law": "axis", "rapid_law": "axis", "source": "test"}})");
    shop_.write("tools.json", R"({"units": "mm", "tools": [
      {"number": 1, "name": "ball", "cutter": {"shape": "ball", "diameter": 8, "length": 60}}]})");
    shop_.write("deep.stl", box_stl({17.67, -7.82, 0.5}, {25.67, 0.18, 62}));
    shop_.write("shallow.stl", box_stl({-24, -2, 0.5}, {-20, 2, 62}));
  }

  /// A position with the tool inclined by 30 degrees to the side of an angle.
  static std::string station(double z, double around) {
    const double angle = around * std::numbers::pi / 180, sine = 0.5;
    std::string text = "GOTO/0,0," + std::to_string(z);
    for (const double part : {sine * std::cos(angle), sine * std::sin(angle), std::sqrt(1 - sine * sine)})
      text += "," + std::to_string(part);
    return text + "\n";
  }
  /// The move from -10 to 10 degrees at z = 30, after positions above at these angles.
  static std::string path_after(const std::vector<double>& angles) {
    std::string text = "UNITS/MM\nMULTAX/ON\nLOADTL/1\nFEDRAT/MMPM,500\n";
    for (const double angle : angles) text += station(120, angle);
    return text + station(120, -10) + station(30, -10) + station(30, 10) + station(120, 10) + "FINI\n";
  }
  [[nodiscard]] Outcome check(const std::string& path, std::vector<std::string> more) const {
    shop_.write("path.apt", path);
    std::vector<std::string> words = {"check",       "path.apt", "--machine",   "machine.json", "--part",
                                      "deep.stl",    "--part",   "shallow.stl", "--tools",      "tools.json",
                                      "--no-config", "--assume", "placement"};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  }

  const SmallShop shop_;
  const std::vector<double> round_ = {0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330, 349};
};

TEST_F(TurnedTable, AnAcceptanceOfOneWayIsNoneOfTheOtherWay) {
  const Outcome first = check(path_after({}), {"--json", "first.json"});
  ASSERT_EQ(first.exit_status, 1) << first.out << first.err;
  const Outcome accepted =
      shop_.run({"accept", "first.json", "--all", "--reason", "test", "--reviewer", "me", "-o", "accepted.json"});
  ASSERT_EQ(accepted.exit_status, 0) << accepted.out << accepted.err;
  const auto with_baseline = [&](const std::string& path) { return check(path, {"--baseline", "accepted.json"}); };
  EXPECT_EQ(with_baseline(path_after({})).exit_status, 0) << "the same program";
  EXPECT_EQ(with_baseline(path_after({30})).exit_status, 0) << "the same motions after another one";
  const Outcome back = with_baseline(path_after(round_));
  EXPECT_EQ(back.exit_status, 1) << "C turns back from 350 to 10 degrees" << back.out << back.err;
}

TEST_F(TurnedTable, AVerificationRecomputesTheMotions) {
  ASSERT_EQ(check(path_after(round_), {"--json", "check.json"}).exit_status, 1);
  const Outcome verified = shop_.run({"verify", "check.json"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
}

TEST_F(TurnedTable, ANoteNamesAnotherStartThatEndsAtALimit) {
  const auto result_of = [&](const std::string& path, std::vector<std::string> more) {
    more.insert(more.end(), {"--json", "start.json"});
    static_cast<void>(check(path, more));
    return shop_.read("start.json");
  };
  const auto has_note = [](const std::string& result) { return result.find("\"machine-start\"") != std::string::npos; };
  const std::string result = result_of(path_after({}), {});
  EXPECT_TRUE(has_note(result)) << result;
  EXPECT_NE(result.find("joint C begins at -10 degrees; its limits also permit 350 degrees"), std::string::npos);
  EXPECT_FALSE(has_note(result_of(path_after(round_), {}))) << "360 degrees are beyond the limit";
  EXPECT_FALSE(has_note(result_of(path_after({}), {"--feed-law", "vector", "--rapid-law", "vector"})));
}

TEST(LinearJoints, InOnePlaneLeaveAMoveOpenByTheLawsOfAllJoints) {
  const SmallShop shop;
  shop.write("machine.json", R"({"name": "X under C", "source": "test", "unit": "mm", "joints": [
    {"name": "X", "type": "linear", "side": "table", "direction": [1, 0, 0]},
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "min": -360, "max": 360},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0], "point": [0, 0, 0], "min": -100, "max": 100},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
    "control": {"name": "c", "feed_law": "joint", "rapid_law": "joint", "source": "test"}})");
  shop.write("part.stl", box_stl({500, 500, 0}, {510, 510, 10}));
  const std::string apart = "GOTO/20,0,30,0,0.5,0.866025404\n", in_plane = "GOTO/0,20,30,-0.5,0,0.866025404\n",
                    beyond = "GOTO/0,20,30,-0.469846310,-0.171010072,0.866025404\n";
  const std::string head = "UNITS/MM\nMULTAX/ON\nCUTTER/4\nLOADTL/1\nFEDRAT/MMPM,500\n";
  const auto check = [&](const std::string& law, const std::string& positions) {
    shop.write("path.apt", head + positions + "FINI\n");
    return shop.run({"check", "path.apt", "--part", "part.stl", "--machine", "machine.json", "--feed-law", law,
                     "--rapid-law", law, "--zero", "0,0,0", "--no-config", "--assume", "placement"});
  };
  const Outcome open = check("joint", apart + in_plane);
  EXPECT_EQ(open.exit_status, 4) << open.out << open.err;
  EXPECT_NE(open.out.find("nearly in one plane"), std::string::npos) << open.out;
  const Outcome across = check("joint", apart + beyond);
  EXPECT_EQ(across.exit_status, 0) << across.out << across.err;
  const Outcome on_line = check("vector", apart + in_plane);
  EXPECT_EQ(on_line.exit_status, 0) << "the law states the motion without joints" << on_line.out << on_line.err;
}

}  // namespace
}  // namespace gouge::testing_samples::joint_facts_test
