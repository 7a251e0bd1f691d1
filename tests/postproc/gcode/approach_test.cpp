// Rapids from places that are not known, at the start of a program and after a tool change.
#include "tests/postproc/gcode/program.h"

namespace gouge {
namespace {

using test::can_be_clean;
using test::path_of_program;
using test::read_program;
using test::reasons_of;

TEST(GcodeApproach, RapidsBeforeAHeightAreLeftOutAndCounted) {
  const ReadOutcome outcome = read_program("G21 G90 G17\nT1 M6\nG0 X5 Y6\nG43 H1 Z30\nG1 Z1 F100\nM2\n", "linuxcnc");
  ASSERT_TRUE(can_be_clean(outcome)) << reasons_of(outcome);
  EXPECT_TRUE(outcome.toolpath->approaches.empty());
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

TEST(GcodeApproach, AWholePositionOrAStepIsNoApproach) {
  // The length of H1 on T2 is not known, or the step begins at a height that is not known.
  EXPECT_FALSE(can_be_clean(
      read_program("G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0 Z20\nT2 M6\nG0 X0 Y0 Z5\nX30\nM2\n", "linuxcnc")));
  EXPECT_FALSE(can_be_clean(
      read_program("G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0\nG91 G0 Z-50\nX10\nG90 G0 X0 Y0 Z50\nM2\n", "linuxcnc")));
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
}  // namespace gouge
