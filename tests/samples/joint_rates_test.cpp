#include <gtest/gtest.h>

#include <algorithm>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Warnings about feeds that rotary joints cannot follow, and about opposite tool axes.

namespace gouge::testing_samples::joint_rates_test {
namespace {

const std::string kTrunnion = "preset:linuxcnc-xyzac-trt";

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

/// Tilts A by 10 degrees and back in each millimetre, at 600 mm/min: 6000 deg/min.
std::string waving(std::size_t moves) {
  std::string text = "UNITS/MM\nLOADTL/1\nMULTAX/ON\nFEDRAT/600,MMPM\nGOTO/0,0,200,0,0,1\n";
  for (std::size_t i = 1; i <= moves; ++i)
    text += "GOTO/" + std::to_string(i) + ",0,200," + (i % 2 == 1 ? "0,-0.17364817767,0.98480775301" : "0,0,1") + "\n";
  return text + "FINI\n";
}

TEST(JointRates, AFeedThatAJointCannotFollowIsAWarning) {
  const SampleFolder sample = open_sample("pole_crossing");
  write_text(sample.path + "/wave.apt", waving(1));
  const auto ran_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"--machine", kTrunnion, "--assume", "placement"};
    words.insert(words.end(), more.begin(), more.end());
    return run_gougecheck(sample.path, sample.arguments("check", "wave.apt", words));
  };
  const Outcome ran = ran_with({});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_TRUE(has(ran.err,
                  "wave.apt:6: warning: joint A needs 6000 deg/min on average at the feed of 600 mm/min; its "
                  "rate is 1800 deg/min"))
      << ran.err;
  EXPECT_FALSE(has(ran_with({"--joint-rate", "A=6001"}).err, "machine-rate"));
  EXPECT_EQ(ran_with({"--warnings-as-errors"}).exit_status, 4);
  const Outcome joint = ran_with({"--feed-law", "joint", "--joint-point", "A=0,0,0", "--joint-point", "C=0,0,0"});
  EXPECT_FALSE(has(joint.err, "machine-rate")) << "the feed does not hold at the tip: " << joint.err;
}

TEST(JointRates, PathJointsNamesTheWorstOfEqualExcesses) {
  const std::string folder = fresh_folder();
  write_text(folder + "/wave.apt", waving(25));
  const Outcome ran =
      run_gougecheck(folder, {"path", "joints", "wave.apt", "--machine", kTrunnion, "--csv", "joints.csv"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "its rate is 1800 deg/min; this is the worst of 25 such feeds")) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
}

TEST(PathLaws, LeavesOutOppositeAxesWithAWarning) {
  const std::string folder = fresh_folder();
  write_text(folder + "/over.apt",
             "UNITS/MM\nMULTAX/ON\nGOTO/0,0,0,1,0,0\nGOTO/1,0,0,0,0,1\nGOTO/2,0,0,0,0,-1\nFINI\n");
  const Outcome ran = run_gougecheck(
      folder, {"path", "laws", "over.apt", "--machine", "preset:haas-umc750", "--joint-limit", "B=-10..200"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "over.apt:5: warning: the tool axis turns to its opposite in 1 move")) << ran.err;
  EXPECT_TRUE(has(ran.out, "feeds that turn                   1\n")) << ran.out;
}

}  // namespace
}  // namespace gouge::testing_samples::joint_rates_test
