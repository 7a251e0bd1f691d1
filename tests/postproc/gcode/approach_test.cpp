// Rapids from places that are not known, at the start of a program and after a tool change.
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/postproc/gcode/program.h"

namespace gouge::approach_test {
namespace {

using test::can_be_clean;
using test::path_of_program;
using test::read_program;
using test::reasons_of;

TEST(GcodeApproach, RapidsBeforeAHeightAreLeftOutAndCounted) {
  const ReadOutcome outcome = read_program("G21 G90 G17\nT1 M6\nG0 X5 Y6\nG43 H1 Z30\nG1 Z1 F100\nM2\n", "linuxcnc");
  ASSERT_TRUE(can_be_clean(outcome)) << reasons_of(outcome);
  ASSERT_EQ(outcome.toolpath->approaches.size(), 1U);  // down to 30 at a place that is known
  EXPECT_NEAR(outcome.toolpath->approaches[0].height_mm, 30, 1e-9);
  ASSERT_EQ(outcome.toolpath->moves.size(), 2U);
  test::expect_tip(outcome.toolpath->moves[0], 5, 6, 30);
  for (const Assumption& fact : outcome.toolpath->assumptions) {
    if (fact.subject != Subject::completeness) continue;
    EXPECT_EQ(fact.basis, Basis::by_default);
    EXPECT_NE(fact.value.find("1 rapid"), std::string::npos) << fact.value;
  }
}

TEST(GcodeApproach, AHeightBeforeThePlaceIsStored) {
  const Toolpath path = path_of_program("G21 G90 G17\nT1 M6\nG43 H1\nG0 Z5\nX10 Y10\nG1 Z1 F100\nM2\n", "linuxcnc");
  ASSERT_EQ(path.approaches.size(), 2U);  // down to the height, and across at it
  for (const ApproachHeight& approach : path.approaches) EXPECT_NEAR(approach.height_mm, 5, 1e-9);
}

// The usual start of posts for Haas and Fanuc: the step of 0 is no motion, and home is a height.
TEST(GcodeApproach, GoingHomeFromAnUnknownPlaceIsAnApproach) {
  ProgramSetup setup;
  setup.home_mm = Vec3::Zero();
  setup.offsets["G54"].xyz_mm = Vec3(-100, -100, -300);
  const std::string text = "G21 G17 G40 G49 G90 G54 G94 G98\nG91 G28 Z0.\nG90\nG0 X0. Y0.\nZ50.\nG1 Z5. F100.\nM30\n";
  for (const char* control : {"haas", "linuxcnc"}) {
    const ReadOutcome outcome = read_program(text, control, setup);
    ASSERT_TRUE(outcome.toolpath) << control;
    EXPECT_EQ(reasons_of(outcome).find("home position"), std::string::npos) << control << reasons_of(outcome);
  }
  std::string step = text;
  step.replace(step.find("Z0."), 3, "Z5.");
  EXPECT_NE(reasons_of(read_program(step, "haas", setup)), "") << "a step from an unknown place is a motion";
}

TEST(GcodeApproach, AHeightWithoutKnownJointsIsNotKnown) {
  ProgramSetup setup;
  setup.machine = test::trunnion();
  const std::string start = "G21 G90 G17\nT1 M6\nG43 H1\nG0 ";
  const auto lowest = [&](const std::string& blocks) {
    double low = std::numeric_limits<double>::infinity();
    for (const ApproachHeight& approach :
         path_of_program(start + blocks + "G1 X1 F100\nM2\n", "linuxcnc", setup).approaches)
      low = std::min(low, approach.height_mm);
    return low;
  };
  EXPECT_NEAR(lowest("A0 C0\nX0 Y0\nZ5\n"), 5, 1e-9);
  EXPECT_NEAR(lowest("X0 Y0 Z5 A90 C0\n"), 5, 1e-9);  // along the tool, whatever the table does
  EXPECT_EQ(lowest("X0 Y0\nZ5\nA0 C0\n"), -std::numeric_limits<double>::infinity());
}

// A machine may leave the tool where it is when a tool is called, above all that in the spindle.
TEST(GcodeApproach, AToolChangeBeginsAtTheHeightBeforeIt) {
  for (const char* call : {"T1 M6\nG43 H1\n", "T2 M6\nG43 H2\n"}) {
    const std::string text =
        std::string("G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0 Z50\nG1 Z-5 F100\n") + call + "G0 X20 Y0\nZ50\nG1 X30\nM2\n";
    const Toolpath path = path_of_program(text, "linuxcnc");
    ASSERT_EQ(path.approaches.size(), 3U) << text;
    EXPECT_NEAR(path.approaches[1].height_mm, -5, 1e-9);
    EXPECT_EQ(path.approaches[1].line, 6U);
  }
}

TEST(GcodeApproach, TheTipOfALongerToolIsLowerAfterAChange) {
  ProgramSetup setup;
  setup.lengths_mm = {{1, 60}, {2, 100}, {3, 40}};
  const auto height_at_change = [&](const std::string& tool) {
    const std::string text = "G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0 Z50\nT" + tool + " M6\nG43 H" + tool +
                             "\nG0 X20 Y0\nZ50\nG1 X30 F9\nM2\n";
    return path_of_program(text, "linuxcnc", setup).approaches.at(1).height_mm;
  };
  EXPECT_NEAR(height_at_change("2"), 50 - 40, 1e-9);
  EXPECT_NEAR(height_at_change("3"), 50, 1e-9);
}

TEST(GcodeApproach, AWholePositionOrAStepIsNoApproach) {
  // The length of H1 on T2 is not known, or the step begins at a height that is not known.
  EXPECT_FALSE(can_be_clean(
      read_program("G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0 Z20\nT2 M6\nG0 X0 Y0 Z5\nX30\nM2\n", "linuxcnc")));
  EXPECT_FALSE(can_be_clean(
      read_program("G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0\nG91 G0 Z-50\nX10\nG90 G0 X0 Y0 Z50\nM2\n", "linuxcnc")));
}

// A program of three axes leaves rotary joints where they are. The reason has the words that state where that is.
TEST(GcodeApproach, TheReasonForUnknownJointsHasTheWordsThatStateThem) {
  const std::string iso = "G21 G17 G40 G49 G80 G90 G94\nT1 M6\nG54 G0 X-20. Y30.\nG43 H1 Z50.\nG1 X120. F500.\nM30\n";
  const std::vector<std::pair<std::string, std::string>> programs = {
      {"linuxcnc", iso},
      {"haas", "%\nO1000\n" + iso},
      {"fanuc", "%\nO1000\n" + iso},
      {"siemens", "G17 G71 G90 G94 G60 G54\nTRAFOOF\nT=\"A\" M6\nD1\nG0 X-20 Y30\nZ50\nG1 X120 F500\nM30\n"},
      {"heidenhain",
       "BEGIN PGM N MM\nTOOL CALL 1 Z S3000\nL X-20 Y30 R0 FMAX\nL Z+50 FMAX\nL X+120 F500\nM30\nEND PGM N MM\n"}};
  for (const auto& [control, text] : programs) {
    ProgramSetup setup;
    setup.machine = test::trunnion();
    setup.offsets["G54"] = WorkOffset{};
    setup.tool_length_mm = 100;
    setup.are_joint_rapids_straight = true;
    const std::string reason = reasons_of(read_program(text, control, setup));
    const std::string begin =
        "the positions of the rotary joints are not known; expected C and A in a block before, or "
        "--start \"";
    const std::size_t at = reason.find(begin);
    ASSERT_NE(at, std::string::npos) << control << ": " << reason;
    const std::size_t first = at + begin.size();
    setup.start = reason.substr(first, reason.find('"', first) - first) + "\n";
    const ReadOutcome stated = read_program(text, control, setup);
    EXPECT_TRUE(stated.toolpath) << control << ": " << reasons_of(stated);
    EXPECT_EQ(reasons_of(stated).find("rotary joints"), std::string::npos) << control << ": " << reasons_of(stated);
  }
}

TEST(GcodeApproach, TheLawVectorDoesNotTurnByHalfATurn) {
  ProgramSetup setup;
  setup.machine = test::trunnion();
  const std::string program = "G21 G90 G17\nT1 M6\nG43 H1\nM428\nG0 A30 C0\nX0 Y0 Z50\nG1 X10 C200 F100\nM2\n";
  setup.laws = TurnLaws{TurnLaw::axis, TurnLaw::axis, TurnLaw::joint};
  EXPECT_TRUE(can_be_clean(read_program(program, "linuxcnc", setup)))
      << reasons_of(read_program(program, "linuxcnc", setup));
  setup.laws = TurnLaws{TurnLaw::vector, TurnLaw::vector, TurnLaw::joint};
  const ReadOutcome outcome = read_program(program, "linuxcnc", setup);
  EXPECT_FALSE(can_be_clean(outcome));
  EXPECT_NE(reasons_of(outcome).find("the law vector leaves out"), std::string::npos) << reasons_of(outcome);
}

}  // namespace
}  // namespace gouge::approach_test
