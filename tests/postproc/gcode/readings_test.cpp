// What a program means: positions, arcs, cycles, frames, calls and loops.
#include <numbers>

#include "tests/postproc/gcode/program.h"

namespace gouge::test::readings_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(GcodeReading, ReadsAbsoluteAndIncrementalPositionsInBothUnits) {
  const Toolpath path = path_of_program("G21 G90 G0 X1 Y2 Z3\nG1 X5 F100\nG91 Z-1\nG20 X1\nG90 X0\nM2\n", "linuxcnc");
  ASSERT_EQ(path.moves.size(), 5u);
  EXPECT_FALSE(path.moves[0].has_start);
  expect_tip(path.moves[1], 5, 2, 3);
  expect_tip(path.moves[2], 5, 2, 2);
  expect_tip(path.moves[3], 30.4, 2, 2);
  expect_tip(path.moves[4], 0, 2, 2);
  EXPECT_EQ(path.moves[1].line, 2u);
  EXPECT_EQ(path.moves[1].kind, MoveKind::feed);
  EXPECT_EQ(path.moves[1].feed_mm, 100);
  EXPECT_TRUE(path.moves[4].has_start);
}

TEST(GcodeReading, ReadsArcsByCentreAndByRadius) {
  const Toolpath path = path_of_program(
      "G21 G90 G17 G0 X0 Y0 Z0\nG3 X2 Y0 I1 F100\nG2 X0 R1\nG2 X0 Y2 R-2\nG2 I1\nG18 G2 X2 I1\nM2\n", "linuxcnc");
  ASSERT_EQ(path.moves.size(), 6u);
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_EQ(path.moves[i].not_checked_reason, "") << i;
    ASSERT_EQ(path.moves[i].curve_kind, CurveKind::arc) << i;
  }
  const auto arc = [&](std::size_t i) { return path.arcs[path.moves[i].curve]; };
  EXPECT_NEAR((arc(1).center - Vec3(1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(arc(1).axis.z(), 1, 1e-12);
  EXPECT_NEAR(arc(1).sweep_rad, kPi, 1e-12);
  EXPECT_NEAR(arc(2).axis.z(), -1, 1e-12);
  EXPECT_NEAR(arc(3).sweep_rad, 2 * kPi - kPi / 3, 1e-9);
  EXPECT_NEAR(arc(4).sweep_rad, 2 * kPi, 1e-12) << "full circle";
  EXPECT_NEAR(arc(5).axis.y(), -1, 1e-12) << "clockwise seen against Y, which is behind Z and X";
}

TEST(GcodeReading, DrillsAsTheControlDoes) {
  const Toolpath path =
      path_of_program("G21 G90 G17 G0 X0 Y0 Z10\nG98 G81 X5 Y5 Z-2 R1 F50\nX9\nG99 Y9\nG80\nG0 X0\nM2\n", "linuxcnc");
  std::vector<double> heights;
  for (const Move& move : path.moves) heights.push_back(move.end.tip.z());
  const std::vector<double> expected = {10, 10, 1, -2, 10, 10, 1, -2, 10, 10, 1, -2, 1, 1};
  EXPECT_EQ(heights, expected);
  EXPECT_EQ(path.moves[3].kind, MoveKind::feed);
  EXPECT_EQ(path.moves[4].kind, MoveKind::rapid);
}

TEST(GcodeReading, TurnsTheTipAroundTheTableWithoutTipControl) {
  ProgramSetup setup;
  setup.machine = trunnion();
  const Toolpath path = path_of_program("G21 G90 G0 X10 Y0 Z5 A0 C0\nG1 C90 F100\nG1 A90\nM2\n", "linuxcnc", setup);
  ASSERT_EQ(path.moves.size(), 3u);
  // The tool stands, and the table turns: in the part the tool turns by the same angle.
  expect_tip(path.moves[1], 0, 10, 5);
  EXPECT_TRUE(path.moves[1].runs_joints);
  ASSERT_NE(path.joints, nullptr);
  EXPECT_NEAR((*path.joints->end[1])[0], kPi / 2, 1e-12);
  EXPECT_NEAR((path.moves[2].end.axis - tool_axes(*setup.machine, {kPi / 2, kPi / 2}).col(2)).norm(), 0, 1e-12);
}

TEST(GcodeReading, KeepsTheTipWithTipControl) {
  ProgramSetup setup;
  setup.machine = machine_of("linuxcnc-xyzac-trt");
  const Toolpath path =
      path_of_program("G21 G90 M428\nG0 X10 Y0 Z5 A0 C0\nG1 C90 A30 F100\nG1 C720\nM2\n", "linuxcnc", setup);
  ASSERT_EQ(path.moves.size(), 3u);
  expect_tip(path.moves[1], 10, 0, 5);
  EXPECT_FALSE(path.moves[1].runs_joints);
  EXPECT_NEAR((*path.joints->end[2])[0], 4 * kPi, 1e-12) << "turns stay";
}

TEST(GcodeReading, GivesTwoWorkOffsetsTheirPlaces) {
  ProgramSetup setup;
  setup.offsets["G54"].xyz_mm = {100, 50, 0};
  setup.offsets["G55"].xyz_mm = {150, 50, 10};
  const Toolpath path = path_of_program("G21 G90 G54 G0 X0 Y0 Z0\nG55 X0 Y0 Z0\nG53 G0 Z5\nM2\n", "linuxcnc", setup);
  ASSERT_EQ(path.moves.size(), 3u);
  expect_tip(path.moves[1], 50, 0, 10);
  expect_tip(path.moves[2], 50, 0, 5);
}

TEST(GcodeReading, TiltsTheFrameOfFanuc) {
  ProgramSetup setup;
  setup.machine = trunnion();
  const Toolpath path = path_of_program(
      "G21 G90 G17 G98\nT1 M6\nG43 H1\nG68.2 X10. Y0. Z0. I0. J90. K0.\nG53.1\nG0 X0. Y0. Z5.\nG1 Z0. F100.\nG69\nM30\n",
      "fanuc", setup);
  ASSERT_GE(path.moves.size(), 2u);
  const Move& last = path.moves.back();
  EXPECT_EQ(last.not_checked_reason, "");
  expect_tip(last, 10, 0, 0);
  EXPECT_NEAR((last.end.axis - Vec3(0, -1, 0)).norm(), 0, 1e-12);
}

TEST(GcodeReading, RunsLoopsConditionsAndSubprograms) {
  const Toolpath path = path_of_program(
      "G21 G90 G0 X0 Y0 Z0\n#1=0\no10 while [#1 lt 3]\n#1=[#1+1]\no20 if [#1 eq 2]\nG1 X#1 F9\no20 else\nG1 Y#1 F9\n"
      "o20 endif\no10 endwhile\no<up> sub\nG1 Z[#1*2]\no<up> endsub\no<up> call [7]\nM2\n",
      "linuxcnc");
  ASSERT_EQ(path.moves.size(), 5u);
  expect_tip(path.moves[1], 0, 1, 0);
  expect_tip(path.moves[2], 2, 1, 0);
  expect_tip(path.moves[3], 2, 3, 0);
  expect_tip(path.moves[4], 2, 3, 14);
  EXPECT_EQ(path.moves[1].line, 8u);
}

TEST(GcodeReading, RunsMacrosOfFanuc) {
  const Toolpath path = path_of_program(
      "%\nO1\nG21 G90 G17 G98\nT1 M6\nG43 H1 G0 X0. Y0. Z0.\n#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nG1 X#1 F9.\nEND1\n"
      "IF [#1 EQ 2] GOTO 50\nG1 X99.\nN50 G1 Y#1\nM98 P200 L2\nM30\nO200\nG91 G1 Z1.\nG90\nM99\n%\n",
      "fanuc");
  ASSERT_EQ(path.moves.size(), 6u);
  expect_tip(path.moves[3], 2, 2, 0);
  expect_tip(path.moves[5], 2, 2, 2);
}

TEST(GcodeReading, CallsProgramsBesideTheFile) {
  ProgramSetup setup;
  setup.read_beside = [](const std::string& name) {
    return name == "square.ngc" ? std::vector<std::string>{"o<square> sub\nG1 X5 F9\no<square> endsub\n"}
                                : std::vector<std::string>{};
  };
  const Toolpath path = path_of_program("G21 G90 G0 X0 Y0 Z0\no<square> call\nM2\n", "linuxcnc", setup);
  ASSERT_EQ(path.moves.size(), 2u);
  expect_tip(path.moves[1], 5, 0, 0);
  EXPECT_EQ(path.moves[1].line, 2u) << "the line of the call";
}

TEST(GcodeReading, KeepsTheSpeedOfTheSpindle) {
  const Toolpath path = path_of_program("G21 G90 G94 S8000 M3\nG0 X0 Y0 Z0\nG1 X10 F5\nS0 X20\nM2\n", "linuxcnc");
  ASSERT_EQ(path.moves.size(), 3u);
  EXPECT_EQ(path.moves[1].spindle_rpm, 8000);
  EXPECT_EQ(path.moves[2].spindle_rpm, Move::kSpindleStopped);
}

TEST(GcodeReading, TurnsInverseTimeIntoFeeds) {
  const Toolpath path = path_of_program("G21 G90 G93 G0 X0 Y0 Z0\nG1 X10 F5\nG1 X20\nM2\n", "linuxcnc");
  EXPECT_EQ(path.moves[1].feed_mm, 50);
  EXPECT_EQ(path.moves[1].feed_unit, FeedUnit::per_minute);
  EXPECT_NE(path.moves[2].not_checked_reason, "") << "F holds for its block";
}

}  // namespace
}  // namespace gouge::test::readings_test
