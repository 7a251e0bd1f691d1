#include <cmath>
#include <numbers>

#include "tests/postproc/gcode/siemens/siemens_program.h"

// Frames of the program, computed by hand.

namespace gouge::siemens_frames_test {
namespace {

using test::expect_at;
using test::full_setup;
using test::tip_after;

const double kRoot2 = std::numbers::sqrt2, kRoot3 = std::numbers::sqrt3;

TEST(SiemensFrames, TransReplacesAndAtransAdds) {
  expect_at(tip_after("TRANS X10 Y20\nG1 X1 Y2 Z3 F100\n"), 11, 22, 3);
  expect_at(tip_after("TRANS X10 Y20\nATRANS X5 Z1\nG1 X1 Y2 Z3 F100\n"), 16, 22, 4);
  expect_at(tip_after("TRANS X10 Y20\nTRANS Z7\nG1 X1 Y2 Z3 F100\n"), 1, 2, 10);
  expect_at(tip_after("TRANS X10\nTRANS\nG1 X1 Y2 Z3 F100\n"), 1, 2, 3);
  expect_at(tip_after("TRANS X10 Y20\nROT\nG1 X1 Y2 Z3 F100\n"), 1, 2, 3);
}

TEST(SiemensFrames, ASingleAxisKeepsTheOthersWhereTheMachineStands) {
  expect_at(tip_after("TRANS X10 Y20\nG1 Z3 F100\n"), 0, 0, 3);
  expect_at(tip_after("TRANS X10 Y20\nG1 X1 F100\n"), 11, 0, 50);
}

TEST(SiemensFrames, RotTurnsAboutZThenTheNewYThenTheNewX) {
  expect_at(tip_after("ROT Z90\nG1 X10 Y0 Z0 F100\n"), 0, 10, 0);
  expect_at(tip_after("ROT RPL=30\nG1 X2 Y0 Z0 F100\n"), kRoot3, 1, 0);
  // Rz(90) Ry(90): x of the frame is -z, y is -x, z is y.
  expect_at(tip_after("ROT Z90 Y90\nG1 X1 Y2 Z3 F100\n"), -2, 3, -1);
  // Rz(90) Rx(90): y of the frame is z, z is x.
  expect_at(tip_after("ROT Z90 X90\nG1 X1 Y2 Z3 F100\n"), 3, 1, 2);
}

TEST(SiemensFrames, ArotTurnsInTheFrameInForce) {
  expect_at(tip_after("TRANS X10\nAROT Z90\nG1 X1 Y2 Z3 F100\n"), 8, 1, 3);
  expect_at(tip_after("ROT Z90\nATRANS X10\nG1 X1 Y0 Z0 F100\n"), 0, 11, 0);
  expect_at(tip_after("ROT Z45\nAROT Z45\nG1 X1 Y0 Z0 F100\n"), 0, 1, 0);
  expect_at(tip_after("ROT Z45\nG1 X1 Y1 Z0 F100\n"), 0, kRoot2, 0);
}

TEST(SiemensFrames, ScaleAndMirror) {
  expect_at(tip_after("SCALE X2 Y3\nG1 X1 Y1 Z1 F100\n"), 2, 3, 1);
  expect_at(tip_after("TRANS X10\nASCALE X2\nG1 X1 Y1 Z1 F100\n"), 12, 1, 1);
  expect_at(tip_after("MIRROR X0\nG1 X1 Y1 Z1 F100\n"), -1, 1, 1);
  expect_at(tip_after("TRANS Y5\nAMIRROR Y1\nG1 X1 Y1 Z1 F100\n"), 1, 4, 1);
}

TEST(SiemensFrames, AMirrorTurnsArcsTheOtherWay) {
  const Toolpath path = test::path_of_siemens(test::kHead + "MIRROR X0\nG1 X10 Y0 Z0 F100\nG3 X0 Y10 I-10 J0\nM30\n");
  ASSERT_EQ(path.arcs.size(), 1U);
  expect_at(path.arcs[0].center, 0, 0, 0);
  expect_at(path.arcs[0].axis, 0, 0, -1);
  EXPECT_NEAR(path.arcs[0].sweep_rad, std::numbers::pi / 2, 1e-12);
  expect_at(path.moves.back().end.tip, 0, 10, 0);
}

TEST(SiemensFrames, ATurnedFrameTurnsArcs) {
  const Toolpath path = test::path_of_siemens(test::kHead + "ROT X90\nG1 X10 Y0 Z0 F100\nG3 X0 Y10 I-10 J0\nM30\n");
  ASSERT_EQ(path.arcs.size(), 1U);
  expect_at(path.arcs[0].axis, 0, -1, 0);
  expect_at(path.moves.back().end.tip, 0, 0, 10);
}

TEST(SiemensFrames, ArcsOfAnUnevenScaleAreNotChecked) {
  const ReadOutcome outcome = test::read_siemens(test::kHead + "SCALE X2\nG1 X10 Y0 Z0 F100\nG3 X0 Y10 I-10 J0\nM30\n");
  EXPECT_NE(test::reasons_of(outcome).find("scales the axes of an arc differently"), std::string::npos);
}

TEST(SiemensFrames, SupaNeedsTheOffsetAndTheLength) {
  EXPECT_FALSE(test::can_be_clean(test::read_siemens(test::kHead + "SUPA G0 Z300 D0\nM30\n")));
  ProgramSetup setup;
  setup.offsets["G54"] = {Vec3(100, 50, 20), Vec3::Zero()};
  setup.tool_length_mm = 80;
  // The gauge point goes to 300, the tip is 80 below it, and the work zero is at 20.
  expect_at(tip_after("SUPA G0 Z300 D0\n", setup), 0, 0, 200);
  // A parameter states whether the length is suppressed too.
  EXPECT_FALSE(test::can_be_clean(test::read_siemens(test::kHead + "SUPA G0 Z300\nM30\n", setup)));
  expect_at(tip_after("TRANS X7 Z9\nG153 G0 X101 Z300 D0\n", setup), 1, 0, 200);
  expect_at(tip_after("ROT Z90\nG153 G0 X101 Y55\n", setup), 1, 5, 50);
}

TEST(SiemensFrames, AfterSupaTheFrameIsInForceAgain) {
  ProgramSetup setup;
  setup.offsets["G54"] = {Vec3(100, 50, 20), Vec3::Zero()};
  setup.tool_length_mm = 80;
  expect_at(tip_after("TRANS X7\nSUPA G0 X101 Z300 D0\nG1 X1 F100\n", setup), 8, 0, 200);
}

TEST(SiemensFrames, OffsetsNeedTheirValues) {
  ProgramSetup setup;
  setup.offsets["G54"] = {Vec3(100, 50, 20), Vec3::Zero()};
  setup.offsets["G505"] = {Vec3(110, 50, 20), Vec3::Zero()};
  expect_at(tip_after("G505\nG1 X1 Y2 Z3 F100\n", setup), 11, 2, 3);
  const ReadOutcome other = test::read_siemens(test::kHead + "G55\nG1 X1 Y2 Z3 F100\nM30\n", setup);
  EXPECT_NE(test::reasons_of(other).find("--offset G55=X,Y,Z"), std::string::npos) << test::reasons_of(other);
  const ReadOutcome zero = test::read_siemens(test::kHead + "G500\nG1 X1 Y2 Z3 F100\nM30\n", setup);
  EXPECT_FALSE(test::can_be_clean(zero));
}

TEST(SiemensFrames, FramesTurnCoordinatesOfTheJointsWhereTheTableIsTurned) {
  // B90 turns the tool from Z to X about (0, 0, -50). The frame's z is then the X of the part.
  ProgramSetup setup = full_setup();
  const Vec3 tip = tip_after("G0 B0 C0\nG0 Z500\nG0 B90\nG1 X0 Y0 Z60 F100\n", setup);
  // Joints: gauge point at z = 160, the axis at -50; the tip is 110 above the axis, along X after the turn.
  expect_at(tip, 110, 0, -50);
  expect_at(tip_after("G0 B0 C0\nG0 Z500\nG0 B90\nTRANS Z60\nG1 X3 Y4 Z0 F100\n", setup), 110, 4, -53);
}

TEST(SiemensFrames, Cycle800ExpandsToItsPlane) {
  ProgramSetup setup = full_setup();
  const std::string swivel =
      "G0 B0 C0\nG0 Z500\nCYCLE800(0,\"TC\",0,57,10,0,0,0,90,0,0,0,5,1)\nG0 X1 Y2 Z3\nG1 X4 F100\nM30\n";
  const Toolpath path = test::path_of_siemens(test::kHead + swivel, setup);
  // Ry(90): x of the plane is -z, y is y, z is x. Zero at (10, 0, 0) and 5 along z.
  expect_at(path.moves.back().end.tip, 10 + 5 + 3, 2, -4);
  expect_at(path.moves.back().end.axis, 1, 0, 0);
  EXPECT_TRUE(path.moves.back().not_checked_reason.empty());
  std::size_t open = 0;
  for (const Move& move : path.moves) open += move.not_checked_reason.empty() ? 0U : 1U;
  EXPECT_EQ(open, 2U);  // the motion that aligns the tool, and the one from there
}

TEST(SiemensFrames, Cycle800ChoosesADirectionAndKeepsTheTipInItsState) {
  for (const char* const state : {"0", "10", "100000", "200000", "200010"}) {
    for (const char* const display : {"", ",0", ",1"}) {
      const std::string call =
          std::string("CYCLE800(1,\"TC1\",") + state + ",57,10,0,0,0,90,0,0,0,5,-1,100" + display + ")";
      const std::string text = test::kHead + "G0 B0 C0\nG0 Z500\n" + call + "\nG0 X1 Y2 Z3\nG1 X4 F100\nM30\n";
      const Toolpath path = test::path_of_siemens(text, full_setup());
      EXPECT_TRUE(path.moves.back().not_checked_reason.empty()) << text;
      const Vec3 tip = path.moves.back().end.tip;
      expect_at(tip, 10 + 5 + 3, 2, -4);
    }
  }
}

TEST(SiemensFrames, Cycle800WithoutArgumentsEndsThePlane) {
  const ReadOutcome outcome = test::read_siemens(
      test::kHead +
          "G0 B0 C0\nG0 Z500\nCYCLE800(0,\"TC\",0,57,0,0,0,0,90,0,0,0,0,1)\nCYCLE800()\nG0 B0 C0\nG0 X1 Y2 Z3\nM30\n",
      full_setup());
  ASSERT_TRUE(outcome.toolpath.has_value());
  expect_at(outcome.toolpath->moves.back().end.tip, 1, 2, 3);
  expect_at(outcome.toolpath->moves.back().end.axis, 0, 0, 1);
}

}  // namespace
}  // namespace gouge::siemens_frames_test
