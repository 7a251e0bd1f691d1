#include <gtest/gtest.h>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// gougecheck machine check and machine draw, as a user meets them.

namespace gouge::testing_samples::machine_check_test {
namespace {

Outcome check(const std::vector<std::string>& more) {
  std::vector<std::string> words = {"machine", "check"};
  words.insert(words.end(), more.begin(), more.end());
  return run_gougecheck(fresh_folder(), words);
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

TEST(MachineCheck, StatesForEachLawWhatIsMissing) {
  const Outcome ran = check({"preset:linuxcnc-xyzac-trt"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(has(ran.out, "every direction up to 100 deg from the axis at joints 0")) << ran.out;
  EXPECT_TRUE(has(ran.out, "feeds and rapids: needs the point of joints C and A (--joint-point)")) << ran.out;
  EXPECT_TRUE(has(ran.out, "law of feeds                      axis: can be used")) << ran.out;
}

TEST(MachineCheck, EndsWith4IfALawInForceCannotBeUsed) {
  const Outcome open = check({"preset:head-ca"});
  EXPECT_EQ(open.exit_status, 4);
  EXPECT_TRUE(has(open.out, "not given: needs --feed-law")) << open.out;
  EXPECT_TRUE(has(open.err, "joint A has no limits")) << open.err;
  std::vector<std::string> words = {"preset:head-ca", "--feed-law", "joint", "--rapid-law", "vector"};
  const Outcome joint = check(words);
  EXPECT_EQ(joint.exit_status, 4);
  EXPECT_TRUE(has(joint.out, "joint: needs the point of joints C and A (--joint-point) and the tool length (--tool-"))
      << joint.out;
  words.insert(words.end(), {"--joint-point", "C=0,0,0", "--joint-point", "A=0,0,0", "--tool-length", "150"});
  EXPECT_EQ(check(words).exit_status, 0);
}

TEST(MachineCheck, NamesDoubts) {
  const std::string folder = fresh_folder();
  write_text(folder + "/m.json", R"({"name": "m", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0], "min": 5, "max": 90, "preference": -1},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
    "control": {"name": "any", "feed_law": "axis", "rapid_law": "axis"}})");
  const Outcome ran = run_gougecheck(folder, {"machine", "check", "m.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out;
  for (const char* text :
       {"m.json: warning: the machine has no source", "the control has no source", "joint A cannot be at 0",
        "joint A has limits that exclude the preferred sign", "exclude the tool axis at joints 0"})
    EXPECT_TRUE(has(ran.err, text)) << text << "\n" << ran.err;
  EXPECT_TRUE(has(ran.out, "some directions between 5 deg and 90 deg")) << ran.out;
  EXPECT_EQ(run_gougecheck(folder, {"machine", "check", "none.json"}).exit_status, 3);
}

TEST(MachineCheck, KnowsThatIntervalsNeedLinearJointsBesideEachOther) {
  const std::string folder = fresh_folder();
  write_text(folder + "/split.json", R"({"name": "split", "source": "a test", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "continuous": true},
    {"name": "X", "type": "linear", "side": "table", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "B", "type": "rotary", "side": "head", "direction": [0, 1, 0], "point": [0, 0, [0, 1]], "min": 0, "max": 90},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
    "control": {"name": "any", "feed_law": "axis", "rapid_law": "joint"}})");
  const Outcome ran = run_gougecheck(folder, {"machine", "check", "split.json", "--tool-length", "100"});
  EXPECT_EQ(ran.exit_status, 4);
  EXPECT_TRUE(has(ran.out, "joint: needs the part zero (--zero) and single values in place of intervals")) << ran.out;
  EXPECT_TRUE(has(ran.out, "axis: can be used")) << ran.out;
}

TEST(MachineDraw, WritesAPicture) {
  const std::string folder = fresh_folder();
  const auto draw = [&](const std::string& file) {
    return run_gougecheck(folder, {"machine", "draw", "preset:haas-umc750", "-o", file, "--joint-limit", "B=-35..110"});
  };
  EXPECT_EQ(draw("m.svg").exit_status, 0);
  const std::string svg = text_of(folder + "/m.svg");
  for (const char* text : {"haas-umc750", "-35 to 110 deg", "part zero", "place of the axis not known"})
    EXPECT_TRUE(has(svg, text)) << text;
  EXPECT_EQ(draw("m.png").exit_status, 0);
  EXPECT_EQ(text_of(folder + "/m.png").substr(1, 3), "PNG");
  EXPECT_EQ(draw("m.jpg").exit_status, 2);
}

}  // namespace
}  // namespace gouge::testing_samples::machine_check_test
