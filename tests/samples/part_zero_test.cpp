#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// The part zero on a machine: motion, limits of linear joints, verification.

namespace gouge::testing_samples::part_zero_test {
namespace {

using Json = nlohmann::json;

const std::string kTrunnion = "preset:linuxcnc-xyzac-trt";

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

/// Turns every position of a path by 90 degrees about X, and shifts it by (10, 20, 30).
std::string turned_path(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    double x = 0, y = 0, z = 0, i = 0, j = 0, k = 0;
    if (std::sscanf(line.c_str(), "GOTO/%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &i, &j, &k) == 6) {
      std::ostringstream turned;
      turned.precision(15);
      turned << "GOTO/" << x + 10 << "," << 20 - z << "," << y + 30 << "," << i << "," << -k << "," << j;
      line = turned.str();
    }
    all += line + "\n";
  }
  return all;
}

class PartZero : public testing::Test {
 protected:
  [[nodiscard]] Outcome check(const std::string& path, const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments("check", path, more));
  }
  [[nodiscard]] Json move_of(const std::string& file) const {
    return Json::parse(text_of(sample_.path + "/" + file)).at("moves").at(0);
  }

  SampleFolder sample_ = open_sample("pole_crossing");
};

TEST_F(PartZero, ATurnedPartOnItsZeroIsThePartThatIsNotTurned) {
  EXPECT_EQ(check(sample_.toolpath(), {"--machine", kTrunnion, "--json", "upright.json"}).exit_status, 1);
  write_text(sample_.path + "/turned.apt", turned_path(text_of(sample_.path + "/" + sample_.toolpath())));
  const std::vector<std::string> turned = {"--machine",          kTrunnion, "--place",    "10,20,30,90,0,0", "--zero",
                                           "-10,-30,20,-90,0,0", "--json",  "turned.json"};
  std::vector<std::string> words = turned;
  words.insert(words.end(), {"--certificate", "proofs.gcp"});
  const Outcome ran = check("turned.apt", words);
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  const Json upright = move_of("upright.json"), move = move_of("turned.json");
  EXPECT_NEAR(move.at("depth"), upright.at("depth").get<double>(), 1e-3);
  EXPECT_EQ(move.at("line"), upright.at("line"));
  EXPECT_NEAR(move.at("witness").at("t"), upright.at("witness").at("t").get<double>(), 0.02);
  const Outcome verified = run_gougecheck(sample_.path, {"verify", "turned.json", "--certificate", "proofs.gcp"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  EXPECT_TRUE(has(verified.out, "1 gouging move proved to be no deeper than said")) << verified.out;
  std::string changed = text_of(sample_.path + "/turned.json");
  EXPECT_TRUE(has(changed, "--zero -10,-30,20,-90,0,0")) << "in the evidence of the law";
  const std::string zero = "\"zero\": \"-10,-30,20,-90,0,0\"";
  ASSERT_TRUE(has(changed, zero)) << changed;
  write_text(sample_.path + "/changed.json",
             changed.replace(changed.find(zero), zero.size(), "\"zero\": \"-10,-30,20,-70,0,0\""));
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "changed.json"}).exit_status, 1);
}

TEST_F(PartZero, LimitsOfLinearJointsApply) {
  const auto check_at = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--machine", kTrunnion, "--joint-point", "A=0,0,0", "--joint-point", "C=0,0,0"});
    return check(sample_.toolpath(), more);
  };
  const Outcome far = check_at({"--zero", "500,0,0", "--json", "far.json"});
  EXPECT_EQ(far.exit_status, 4) << far.out;
  EXPECT_TRUE(has(far.err, "joint X would be at ") && has(far.err, "its limit is 200 mm")) << far.err;
  const Outcome open = check_at({"--zero", "0,0,0"});
  EXPECT_TRUE(has(open.err,
                  "limits of joint Z are not checked, because they depend on facts that are not given; state "
                  "the tool length"))
      << open.err;
  const Outcome high = check_at({"--zero", "0,0,0", "--tool-length", "500"});
  EXPECT_EQ(high.exit_status, 4) << high.out;
  EXPECT_TRUE(has(high.err, "joint Z would be at ")) << high.err;
}

TEST_F(PartZero, LimitsThatDependOnAPointThatIsNotGivenAreNotChecked) {
  const Outcome open = check(sample_.toolpath(), {"--machine", kTrunnion, "--zero", "500,0,0", "--tool-length", "5"});
  EXPECT_TRUE(has(open.err, "state the points of the rotary joints (--joint-point)")) << open.err;
  EXPECT_FALSE(has(open.err, "joint X would be at ")) << open.err;
}

TEST_F(PartZero, AMoveBeyondALimitIsRefutedIfAResultCallsItClean) {
  const std::vector<std::string> words = {"--machine",   kTrunnion, "--joint-point", "A=0,0,0",    "--joint-point",
                                          "C=0,0,0",     "--zero",  "0,0,0",         "--feed-law", "vector",
                                          "--rapid-law", "vector",  "--json",        "clean.json"};
  EXPECT_EQ(check(sample_.toolpath(), words).exit_status, 0);
  std::string text = text_of(sample_.path + "/clean.json");
  const std::string zero = "\"zero\": \"0,0,0\"";
  ASSERT_TRUE(has(text, zero));
  write_text(sample_.path + "/forged.json", text.replace(text.find(zero), zero.size(), "\"zero\": \"500,0,0\""));
  const Outcome ran = run_gougecheck(sample_.path, {"verify", "forged.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out;
  EXPECT_TRUE(has(ran.out, "it cannot be checked: the machine cannot be there: joint X would be beyond its limit, "))
      << ran.out;
}

TEST_F(PartZero, IsRefusedWithoutAMachineAndInOtherForms) {
  const Outcome alone = check(sample_.toolpath(), {"--zero", "0,0,0"});
  EXPECT_EQ(alone.exit_status, 2);
  EXPECT_TRUE(has(alone.err, "--zero 0,0,0: expected --machine beside it")) << alone.err;
  const Outcome wrong = check(sample_.toolpath(), {"--machine", kTrunnion, "--zero", "0,0"});
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_TRUE(has(wrong.err, "--zero '0,0': expected x,y,z or x,y,z,rx,ry,rz")) << wrong.err;
}

TEST_F(PartZero, PathJointsCountFromTheMachine) {
  const Outcome ran =
      run_gougecheck(sample_.path, {"path", "joints", sample_.toolpath(), "--machine", kTrunnion, "--zero",
                                    "1,2,0,0,0,90", "--joint-limit", "A=-100..0", "--csv", "-"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  // C turns by 90 degrees more than without the turn of the part, in the sense opposite to ISO 841.
  EXPECT_TRUE(has(ran.out, ",-135.000000,-9.99999")) << ran.out;
}

TEST(PartZeroOfHead, AShiftIsThatOfThePointsOfTheTable) {
  const SampleFolder sample = open_sample("rapid_joints");
  const auto depth_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"--machine", "machine.json", "--tool-length", "100", "--json", "check.json"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_gougecheck(sample.path, sample.arguments("check", sample.toolpath(), words)).exit_status, 1);
    return Json::parse(text_of(sample.path + "/check.json")).at("moves").at(0).at("depth").get<double>();
  };
  const double placed = depth_with({"--zero", "5,7,9"});
  EXPECT_NEAR(placed, depth_with({"--joint-point", "C=-5,-7,-9"}), 1e-3);
  EXPECT_EQ(run_gougecheck(sample.path, {"verify", "check.json"}).exit_status, 0);
}

}  // namespace
}  // namespace gouge::testing_samples::part_zero_test
