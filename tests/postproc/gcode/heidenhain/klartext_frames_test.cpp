#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/postproc/gcode/heidenhain/klartext.h"

namespace gouge::klartext::klartext_frames_test {
namespace {

const std::string kStart = "L X+10 Y+0 Z+5 R0 FMAX\n";

std::string shift(const std::string& x, const std::string& y, const std::string& z) {
  return "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 " + x + "\nCYCL DEF 7.2 " + y + "\nCYCL DEF 7.3 " + z + "\n";
}
std::string rotation(const std::string& word) { return "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 " + word + "\n"; }
std::string mirror(const std::string& axes) { return "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 " + axes + "\n"; }
std::string scale(const std::string& factor) { return "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL " + factor + "\n"; }

TEST(KlartextFrames, AreShifted) {
  EXPECT_EQ(tips(blocks_of(shift("X+100", "Y-20", "Z+3") + kStart + "L IX+1\n")), "(110,-20,8) (111,-20,8)");
  EXPECT_EQ(tips(blocks_of(shift("X+100", "Y+0", "Z+0") + kStart + shift("IX+5", "Y+0", "Z+0") + "L X+0\n" +
                           shift("X+0", "Y+0", "Z+0") + "L X+0\n")),
            "(110,0,5) (105,0,5) (0,0,5)");
}

TEST(KlartextFrames, AreNotKnownByHalfAShift) {
  expect_open(shift("X+100", "Y+1", "Z+0") + "CYCL DEF 7.0 X\nCYCL DEF 7.1 X+0\n" + kStart, "leaves out an axis");
  EXPECT_EQ(tips(blocks_of("CYCL DEF 7.0 X\nCYCL DEF 7.1 X+100\n" + kStart)), "(110,0,5)");
  expect_open("CYCL DEF 7.0 X\nCYCL DEF 7.1 #5\n" + kStart, "not understood");
  expect_open("CYCL DEF 7.0 X\nCYCL DEF 7.1 X+Q9\n" + kStart, "not known");
  EXPECT_EQ(
      tips(blocks_of(kStart + "CYCL DEF 7.0 X\nCYCL DEF 7.1 X+Q9\n" + shift("X+0", "Y+0", "Z+0") + kStart + "L X+0\n")),
      "(10,0,5) open (0,0,5)");
  // A second whole shift keeps the start of the next motion.
  EXPECT_EQ(tips(blocks_of(shift("X+1", "Y+2", "Z+3") + kStart + shift("X+5", "Y+6", "Z+7") + kStart)),
            "(11,2,8) (15,6,12)");
}

TEST(KlartextFrames, AreRotated) {
  const Toolpath path = blocks_of(shift("X+100", "Y+0", "Z+0") + rotation("ROT+90") + kStart +
                                  "CC X+0 Y+0\nC X+0 Y+10 DR+ F100\n" + rotation("IROT+90") + "L X+10 Y+0 F100\n");
  EXPECT_EQ(tips(path), "(100,10,5) (90,0,5) (90,0,5)");
  const PathArc arc = path.arcs[path.moves[1].curve];
  EXPECT_NEAR((arc.center - Vec3(100, 0, 5)).norm(), 0, 1e-9);
  EXPECT_NEAR(arc.sweep_rad, std::numbers::pi / 2, 1e-9);
}

// Cycle 10 is active for both axes of the plane only after a motion of both.
TEST(KlartextFrames, AreRotatedOnceBothAxesMove) {
  expect_open(kStart + rotation("ROT+90") + "L X+10 F100\n", "is active after a motion of X and Y");
  expect_open(kStart + rotation("ROT+90") + "L IY+10 F100\n", "is active after a motion of X and Y");
  EXPECT_EQ(tips(blocks_of(kStart + rotation("ROT+90") + "L Z+4 F100\nL X+10 Y+0\nL X+20\n")),
            "(10,0,5) (10,0,4) (0,10,4) (0,20,4)");
  EXPECT_EQ(tips(blocks_of(kStart + rotation("ROT+90") + "L X+10 F100\nL X+10 Y+0\nL X+20\n")),
            "(10,0,5) open open (0,20,5)");
}

TEST(KlartextFrames, StayWhereTheRotationInForceIsStatedAgain) {
  EXPECT_EQ(tips(blocks_of(kStart + rotation("ROT+0") + "L X+20 F100\n")), "(10,0,5) (20,0,5)");
  EXPECT_EQ(tips(blocks_of(rotation("ROT+90") + kStart + rotation("ROT+90") + "L X+20 F100\n")), "(0,10,5) (0,20,5)");
  expect_open(rotation("ROT+90") + kStart + rotation("ROT+0") + "L X+20 F100\n", "is active after a motion of X and Y");
  expect_open(rotation("ROT+90") + kStart + rotation("IROT+0") + "L X+20 F100\n",
              "is active after a motion of X and Y");
}

TEST(KlartextFrames, AreMirroredWithTheirArcs) {
  const Toolpath path = blocks_of(mirror("X") + kStart + "CC X+0 Y+0\nC X+0 Y+10 DR+ F100\n" + mirror("") + "L X+1\n");
  EXPECT_EQ(tips(path), "(-10,0,5) (0,10,5) (1,10,5)");
  EXPECT_DOUBLE_EQ(path.arcs[path.moves[1].curve].axis.z(), -1);
  const Toolpath both = blocks_of(mirror("X Y") + kStart + "CC X+0 Y+0\nC X+0 Y+10 DR+ F100\n");
  EXPECT_EQ(tips(both), "(-10,0,5) (0,-10,5)");
  EXPECT_DOUBLE_EQ(both.arcs[both.moves[1].curve].axis.z(), 1);
}

TEST(KlartextFrames, NeedTheirAnglesInOrder) {
  expect_open(kStart + "PLANE SPATIAL SPC+40 SPB+30 SPA+20 STAY\n" + kStart, "SPA, SPB and SPC, in this order");
}

TEST(KlartextFrames, AreNotKnownByAScale) {
  expect_open(scale("2") + kStart, "which axes a scale changes");
  EXPECT_EQ(tips(blocks_of(scale("1") + kStart)), "(10,0,5)");
}

TEST(KlartextFrames, AreNotKnownInOrdersThatNoManualStates) {
  expect_open(rotation("ROT+90") + mirror("X") + kStart, "the order");
  expect_open(rotation("ROT+90") + shift("X+1", "Y+0", "Z+0") + kStart, "its directions");
  expect_open(rotation("ROT+Q1") + kStart, "not known");
  expect_open(scale("0") + kStart, "scale");
  // A whole reset makes the frame known again.
  const std::string reset = rotation("ROT+0") + mirror("") + shift("X+0", "Y+0", "Z+0");
  EXPECT_EQ(count_open(blocks_of(rotation("ROT+90") + mirror("X") + reset + kStart)), 0U);
}

TEST(KlartextFrames, AreTiltedByMoveAndTurn) {
  for (const std::string positioning :
       {"TURN FMAX", "MOVE DIST50 F1000", "TURN F5000 SEQ- TABLE ROT", "MOVE SYM+ F MAX"}) {
    const Toolpath path = blocks_of(shift("X+100", "Y+0", "Z+0") + "PLANE SPATIAL SPA+0 SPB+90 SPC+0 " + positioning +
                                    "\nL X+1 Y+2 Z+3 FMAX\nL Z+1 F100\n");
    // SPB+90 turns Z to X and X to -Z.
    EXPECT_EQ(tips(path), "(103,2,-1) (101,2,-1)") << positioning;
    EXPECT_NEAR((path.moves.back().end.axis - Vec3(1, 0, 0)).norm(), 0, 1e-12);
  }
}

TEST(KlartextFrames, AreTiltedAboutFixedAxesInTheirOrder) {
  const Toolpath path = blocks_of("PLANE SPATIAL SPA+45 SPB+0 SPC+90 TURN FMAX\nL X+0 Y+0 Z+10 FMAX\nL Y+10 F100\n");
  // A+45 about X brings Z to (0, -s, s), then C+90 about Z brings it to (s, 0, s).
  const double s = std::numbers::sqrt2 / 2;
  EXPECT_NEAR((path.moves.back().end.axis - Vec3(s, 0, s)).norm(), 0, 1e-12);
  EXPECT_NEAR((path.moves.back().end.tip - Vec3(10 * s - 10 * s, 0, 10 * s + 10 * s)).norm(), 0, 1e-9);
}

TEST(KlartextFrames, TurnRotaryAxesAfterStay) {
  const std::string stay = "PLANE SPATIAL SPA+0 SPB+90 SPC+0 STAY\n";
  EXPECT_EQ(tips(blocks_of(kStart + stay + "L X+1 Y+2 Z+3 FMAX\nL X+0\n")), "(10,0,5) open open");
  EXPECT_EQ(tips(blocks_of(stay + "L B+Q121 C+Q122 FMAX\nL X+1 Y+2 Z+3 FMAX\nL X+0\n")), "(3,2,-1) (3,2,0)");
  expect_open(kStart + stay + "L B+Q120 C+Q122 FMAX\nL X+1 Y+2 Z+3 FMAX\n", "Q120, Q121 and Q122");
  expect_open(kStart + stay + "L B+90 C+0 FMAX\nL X+1 Y+2 Z+3 FMAX\n", "Q120, Q121 and Q122");
  expect_open(kStart + stay + "L B+Q121 FMAX\nL X+1 Y+2 Z+3 FMAX\n", "Q120, Q121 and Q122");
}

TEST(KlartextFrames, EndTheirTilt) {
  const std::string tilt = kStart + "PLANE SPATIAL SPA+0 SPB+90 SPC+0 TURN FMAX\nL X+1 Y+2 Z+3 FMAX\n";
  const Toolpath path = blocks_of(tilt + "PLANE RESET TURN FMAX\nL X+1 Y+2 Z+3 FMAX\nL X+0\n");
  EXPECT_EQ(tips(path), "(10,0,5) open open open open (0,2,3)");
  EXPECT_NEAR(path.moves.back().end.axis.z(), 1, 1e-12);
  // Without a machine nothing states where the rotary axes stay.
  expect_open(tilt + "PLANE RESET STAY\nL X+1 Y+2 Z+3 FMAX\nL X+0\n", "expected --machine");
  EXPECT_EQ(count_open(blocks_of("PLANE RESET STAY\n" + kStart)), 0U);
}

TEST(KlartextFrames, AreRefusedInOtherForms) {
  for (const std::string form : {"PROJECTED PROPR+24 PROMIN+24 ROT+30 STAY", "EULER EULPR45 EULNU20 EULROT22 STAY",
                                 "VECTOR BX0.8 BY-0.4 BZ-0.42 NX0.2 NY0.2 NZ0.92 STAY", "RELATIV SPB-45 STAY",
                                 "AXIAL B-45 STAY", "SPATIAL SPA+1 SPB+2 STAY", "SPATIAL SPA+1 SPB+2 SPC+3",
                                 "SPATIAL SPA+1 SPB+2 SPC+3 TURN MOVE", "SPATIAL SPA+1 SPB+2 SPC+3 TURN FOO", "RESET"})
    expect_open(kStart + "PLANE " + form + "\nL X+1\n", "not understood");
  expect_open(kStart + "PLANE SPATIAL SPA+Q1 SPB+0 SPC+0 TURN FMAX\nL X+1 Y+1 Z+1\n", "not known");
  expect_open(kStart + "PLANE SPATIAL SPA+0 SPB+90 SPC+0 TURN FMAX\n" + rotation("ROT+10") +
                  "PLANE RESET TURN FMAX\nL X+1 Y+1 Z+1\n",
              "ends before");
}

TEST(KlartextFrames, OfCycle19NeedAFactOfTheMachine) {
  const std::string cycle = "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+90 C+0\n";
  const std::string aligned = cycle + "L B+Q121 C+Q122 FMAX\nL X+1 Y+2 Z+3 FMAX\nL X+0\n";
  expect_open(kStart + aligned, "spatial or of the rotary axes");
  EXPECT_EQ(count_open(blocks_of("CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+0 B+0 C+0\n" + kStart)), 0U);
  GcodeOptions options;
  options.setup.start = "CYCL DEF 19 SPATIAL\n";
  EXPECT_EQ(tips(blocks_of(aligned, options)), "(3,2,-1) (3,2,0)");
  expect_open("CYCL DEF 19.0 X\nCYCL DEF 19.1 B+90\n" + kStart, "does not state A, B and C", options);
  expect_open("CYCL DEF 19.0 X\nCYCL DEF 19.1 A+0 B+90 B+90\n" + kStart, "each once", options);
  expect_open("CYCL DEF 19 SPATIAL\n" + kStart, "not read");  // no block of a program
}

TEST(KlartextFrames, BeginAtTheirPreset) {
  EXPECT_EQ(
      tips(blocks_of(shift("X+100", "Y+0", "Z+0") + "CYCL DEF 247 DATUM SETTING ~\nQ339=+2 ;DATUM NUMBER\n" + kStart)),
      "(10,0,5)");
  EXPECT_EQ(tips(blocks_of("CYCL DEF 247 DATUM SETTING Q339=+2\n" + shift("X+100", "Y+0", "Z+0") + kStart)),
            "(110,0,5)");
  expect_open(kStart + "CYCL DEF 247 X Q339=+2\n" + kStart, "--offset");
  GcodeOptions options;
  options.setup.offsets["PRESET"] = {Vec3(1, 2, 3), Vec3::Zero()};
  options.setup.offsets["PRESET2"] = {Vec3(11, 2, 3), Vec3::Zero()};
  EXPECT_EQ(tips(blocks_of(kStart + "CYCL DEF 247 X Q339=+2\n" + kStart, options)), "(10,0,5) (20,0,5)");
}

}  // namespace
}  // namespace gouge::klartext::klartext_frames_test
