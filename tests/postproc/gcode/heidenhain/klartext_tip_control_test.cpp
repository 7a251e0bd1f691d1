#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/postproc/gcode/heidenhain/klartext.h"

// Simultaneous programs, written from the manuals: no public one with its part was found.

namespace gouge::klartext::klartext_tip_control_test {
namespace {

const std::string kStart = "L B+0 C+0 R0 FMAX\nL X+0 Y+0 Z+50 FMAX\n";
const std::string kTcpm = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-TIP\n";

// A C table and a B head: the tool axis is (sin B cos C, -sin B sin C, cos B) in the part.
GcodeOptions machine() { return on_placed_machine("table-b-head"); }

GcodeOptions machine_with_tip() {
  GcodeOptions options = machine();
  options.setup.start = "REFPNT TIP-TIP\n";
  return options;
}

Vec3 last_axis(const Toolpath& path) { return path.moves.empty() ? Vec3::Zero() : path.moves.back().end.axis; }

TEST(KlartextTipControl, HasTheTipOnThePart) {
  const Toolpath path = blocks_of(kStart + kTcpm + "L X+10 Y+20 Z+5 B+30 C+60 F500\n", machine());
  ASSERT_EQ(count_open(path), 0U) << last_reason(path);
  const Move& move = path.moves.back();
  EXPECT_FALSE(move.runs_joints);
  EXPECT_NEAR((move.end.tip - Vec3(10, 20, 5)).norm(), 0, 1e-9);
  const double b = std::numbers::pi / 6, c = std::numbers::pi / 3;
  EXPECT_NEAR(last_axis(path).z(), std::cos(b), 1e-12);
  EXPECT_NEAR(last_axis(path).x(), std::sin(b) * std::cos(c), 1e-12);
  EXPECT_NEAR(std::abs(last_axis(path).y()), std::sin(b) * std::sin(c), 1e-12);
  ASSERT_TRUE(path.joints);
  ASSERT_TRUE(path.joints->end.back());
}

TEST(KlartextTipControl, KeepsTheTurnsOfRotaryAxes) {
  const Toolpath path =
      blocks_of(kStart + kTcpm + "L IC+100 F500\nL IC+100\nL IC+100\nL IC+100\nL IB+10 C+300\n", machine());
  ASSERT_EQ(count_open(path), 0U) << last_reason(path);
  EXPECT_NEAR((*path.joints->end[path.moves.size() - 2])[0], 400 * std::numbers::pi / 180, 1e-9);
  EXPECT_NEAR((*path.joints->end.back())[0], 300 * std::numbers::pi / 180, 1e-9);
}

TEST(KlartextTipControl, BeginsByM128AndEndsByM129) {
  const Toolpath path =
      blocks_of(kStart + "L X+10 Y+20 Z+5 B+30 C+60 F500 M128 F1000\nL X+20 M129\nL X+30\n", machine_with_tip());
  ASSERT_EQ(path.moves.size(), 4U);
  EXPECT_EQ(count_open(path), 0U) << last_reason(path);
  EXPECT_FALSE(path.moves[1].runs_joints);
  EXPECT_FALSE(path.moves[2].runs_joints);  // M129 acts at the end of its block
  EXPECT_TRUE(path.moves[3].runs_joints);
  EXPECT_DOUBLE_EQ(path.moves[1].feed_mm, 500);
  EXPECT_EQ(blocks_of(kStart + "L X+10 M128 FMAX\n", machine_with_tip()).moves.back().kind, MoveKind::rapid);
  EXPECT_EQ(count_open(blocks_of(kStart + kTcpm + "L X+5 F100\nFUNCTION RESET TCPM\nL X+6\n", machine())), 0U);
}

// Trap 17: the manual of M128 wants lengths to the centre of a ball.
TEST(KlartextTipControl, NeedsThePointOfTheTool) {
  expect_open(kStart + "L X+10 M128 F100\n", "expected --start \"REFPNT TIP-TIP\"", machine());
  expect_open(kStart + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X+10 F100\n", "centre of a ball", machine());
  EXPECT_EQ(
      count_open(blocks_of(kStart + "FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS\nL X+10 F100\n", machine_with_tip())),
      0U);
  expect_open(kStart + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-CENTER\nL X+1 F100\n", "not understood",
              machine());
}

TEST(KlartextTipControl, NeedsAMachine) {
  for (const std::string block : {"L X+1 M128\n", "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n", "L B+30 FMAX\n"}) {
    const ReadOutcome outcome = outcome_of(with_ends("L X+0 Y+0 Z+9 FMAX\n" + block));
    ASSERT_FALSE(outcome.toolpath) << block;
    EXPECT_EQ(outcome.errors.front().code, "gcode-machine");
  }
  const ReadOutcome other = outcome_of(with_ends(kStart + "L A+3\n"), machine());
  ASSERT_FALSE(other.toolpath);
  EXPECT_EQ(other.errors.front().code, "gcode-machine");
}

TEST(KlartextTipControl, IsNotCheckedWhereTheControlChoosesPositions) {
  expect_open(kStart + "FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS REFPNT TIP-TIP\nL B+30 F100\n", "AXIS SPAT",
              machine());
  expect_open(kStart + "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR REFPNT TIP-TIP\nL B+30 F100\n", "PATHCTRL VECTOR",
              machine());
  // After it nothing states the rotary positions until the program does.
  expect_open(
      kStart +
          "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL B+30 F100\nFUNCTION RESET TCPM\nL X+0 Y+0 Z+9 FMAX\nL X+3\n",
      "not known", machine());
}

TEST(KlartextTipControl, IsLostByOptionsWithoutAMeaning) {
  for (const std::string option :
       {"", "F TCP", "F TCP AXIS POS", "F TCP PATHCTRL AXIS", "F TCP AXIS POS PATHCTRL AXIS FOO",
        "F TCP F TCP AXIS POS PATHCTRL AXIS", "AXIS POS F TCP PATHCTRL AXIS"})
    expect_open(kStart + "FUNCTION TCPM " + option + "\nL X+1 F100\n", "not understood", machine_with_tip());
  expect_open(kStart + "FUNCTION MODE TURN\nL X+1\n", "not understood", machine());
}

// Only positions without tip control depend on the length of the tool on a rotary head.
TEST(KlartextTipControl, NeedsTheLengthOnlyWhileItIsOff) {
  GcodeOptions options = machine_with_tip();
  options.setup.tool_length_mm.reset();
  const std::string with_tip =
      "L B+0 C+0 R0 FMAX\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X+0 Y+0 Z+50 F100\nL X+5 B+10\n";
  const Toolpath path = blocks_of(with_tip, options);
  EXPECT_TRUE(path.moves.back().not_checked_reason.empty()) << last_reason(path);
  EXPECT_GT(count_open(blocks_of(with_tip + "FUNCTION RESET TCPM\nL X+0 Y+0 Z+50 B+20 F100\nL X+5\n", options)), 1U);
  // The same after a tool change under tip control.
  EXPECT_GT(count_open(blocks_of(with_tip + "TOOL CALL 2 Z S1\nL M129\nL X+0 Y+0 Z+50 B+20 F100\nL X+5\n", options)),
            1U);
}

// Trap 14: M128 with M91 and TOOL CALL.
TEST(KlartextTipControl, MustEndBeforeTheMachineDatumAndTheTool) {
  GcodeOptions options = machine_with_tip();
  options.setup.offsets["PRESET"] = {Vec3(0, 0, -400), Vec3::Zero()};
  expect_open(kStart + "L X+10 F100 M128\nL Z-5 M91\n", "under M128", options);
  EXPECT_EQ(count_open(blocks_of(kStart + "L Z-5 FMAX M91\n", options)), 0U);
  expect_open(kStart + "L X+10 F100 M128\nTOOL CALL 2 Z S1\nL X+0 Y+0 Z+9 FMAX\nL B+10 F100\n", "tool centre point",
              options);
}

TEST(KlartextRotary, RunsJointsWithoutTipControl) {
  const Toolpath path = blocks_of(kStart + "L C+90 F500\nL X+10\n", machine());
  ASSERT_EQ(count_open(path), 0U) << last_reason(path);
  EXPECT_TRUE(path.moves.back().runs_joints);
  // The table has turned the part by 90 degrees, and the joints go to X10: a place at 90 degrees in the part.
  EXPECT_NEAR(path.moves.back().end.tip.x(), 0, 1e-9);
  EXPECT_NEAR(std::abs(path.moves.back().end.tip.y()), 10, 1e-9);
}

TEST(KlartextRotary, GoesByHalfATurnAndMoreOnlyWhereItsWayIsKnown) {
  const std::string far = kStart + kTcpm + "L C+170 F500\nL C+350\nL B+1 C+10\n";
  expect_open(far, "--rotary-turns", machine());
  GcodeOptions told = machine();
  told.setup.winds_as_programmed = true;
  const Toolpath path = blocks_of(far, told);
  EXPECT_EQ(count_open(path), 0U) << last_reason(path);
  EXPECT_NEAR((*path.joints->end.back())[0], 10 * std::numbers::pi / 180, 1e-9);
  // M126: the shorter way, so that the joint winds.
  const Toolpath shorter = blocks_of(kStart + kTcpm + "L C+170 F500 M126\nL C+340\nL B+1 C+10\n", machine());
  EXPECT_EQ(count_open(shorter), 0U) << last_reason(shorter);
  EXPECT_NEAR((*shorter.joints->end.back())[0], 370 * std::numbers::pi / 180, 1e-9);
  expect_open(kStart + kTcpm + "L C+170 F500 M126\nL C+350\n", "half a turn", machine());
  // No manual states whether the control counts a turn that M126 completes.
  GcodeOptions winds = machine();
  winds.setup.winds_as_programmed = true;
  expect_open(kStart + kTcpm + "L C+170 F500 M126\nL C+340\nL C+10\nL X+1 M127\nL C+20\n", "beyond a turn", winds);
  EXPECT_EQ(tips(blocks_of(kStart + kTcpm + "L C+170 F500 M126\nL C+300\nL X+1 M127\nL C+20\n", winds)).find("open"),
            std::string::npos);
  expect_open(kStart + kTcpm + "L C+170 F500 M126\nL C+171 M127\n", "M127", machine());
  expect_open(kStart + kTcpm + "L C+170 F500 M126\nL X+1 M127\nL C+370\n", "--rotary-turns", machine());
}

TEST(KlartextRotary, IsNotKnownBeforeTheProgramStatesIt) {
  expect_open("L X+0 Y+0 Z+50 FMAX\nL X+1 F100\n", "rotary joints", machine());
  expect_open(kStart + kTcpm + "L B+Q1 F100\n", "the value of a rotary axis", machine());
}

TEST(KlartextRotary, InATiltedPlaneLosesTheFrame) {
  expect_open(
      kStart + "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\nL X+0 Y+0 Z+9 FMAX\nL B+10 F100\nL X+0 Y+0 Z+9\nL X+3\n",
      "turn in a tilted plane", machine());
}

TEST(KlartextRotary, GoesHomeAtTheEndOfATilt) {
  const Toolpath path = blocks_of(kStart +
                                      "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\nL X+0 Y+0 Z+9 F100\nL X+5\n"
                                      "PLANE RESET TURN FMAX\nL X+0 Y+0 Z+60 F100\nL X+3\n",
                                  machine());
  EXPECT_TRUE(path.moves.back().not_checked_reason.empty()) << last_reason(path);
  EXPECT_NEAR(last_axis(path).z(), 1, 1e-12);
  const double s = std::numbers::sqrt2 / 2;
  EXPECT_NEAR((path.moves[4].end.axis - Vec3(s, 0, s)).norm(), 0, 1e-12);
}

TEST(KlartextRotary, StaysWhereItIsWithoutAnEndOfItsTilt) {
  expect_open(
      kStart +
          "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\nL X+0 Y+0 Z+9 F100\nPLANE RESET STAY\nL X+0 Y+0 Z+60 F100\nL X+3\n",
      "not known", machine());
}

TEST(KlartextRotary, IsRefusedAlongArcs) {
  expect_open(kStart + kTcpm + "CC X+5 Y+0\nC X+5 Y+5 C+10 DR- F100\n", "along an arc", machine());
}

}  // namespace
}  // namespace gouge::klartext::klartext_tip_control_test
