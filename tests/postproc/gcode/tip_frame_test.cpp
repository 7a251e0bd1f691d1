// Coordinates of tool centre point control on a table that is not at 0 where the control begins.
#include "tests/postproc/gcode/program.h"
#include "tests/support/scatter.h"

namespace gouge::test::tip_frame_test {
namespace {

ProgramSetup with_frame(TipFrame frame) {
  ProgramSetup setup;
  setup.machine = trunnion();
  setup.tip_frame = frame;
  setup.feed_law = TurnLaw::documented;
  setup.winds_as_programmed = true;
  setup.are_joint_rapids_straight = true;
  setup.tool_length_mm = 100;
  return setup;
}

std::string program(const std::string& before, const std::string& call) {
  return "G21 G90 G17 G54\nT1 M6\n" + before + "\n" + call + "\nG0 X10. Y20. Z30.\nG1 X11. F100.\nM30\n";
}

TEST(TipFrame, OfATableThatMayNotBeAtZeroMustBeStated) {
  const ProgramSetup setup = with_frame(TipFrame::table);
  for (const char* before : {"G0 A0. C90.", "G0 A30. C0.", "G0 A0. C90.\nG0 A30. C0."})
    expect_open(program(before, "G43.4 H1"), "fanuc", "table-at-zero or table-at-call", setup);
  expect_open(program("G0 A0. C0.", "G43.4 H1 G0 C90."), "fanuc", "table-at-zero or table-at-call", setup);
  expect_open(program("G0 A0. C90.", "G43.4 H1 G0 C0."), "fanuc", "table-at-zero or table-at-call", setup);
  expect_open(program("", "G43.4 H1"), "fanuc", "the positions of the rotary joints are not known", setup);
  expect_open(program("", "G43.4 H1\nG0 A0. C0."), "fanuc", "the positions of the rotary joints are not known", setup);
  expect_checked(program("G0 A0. C0.", "G43.4 H1"), "fanuc", setup);
  expect_checked(program("", "G43.4 H1 G0 A0. C0. X1. Y1. Z90."), "fanuc", setup);
}

TEST(TipFrame, AtZeroTakesCoordinatesOfThePart) {
  const ProgramSetup setup = with_frame(TipFrame::table_at_zero);
  for (const char* before : {"", "G0 A0. C0.", "G0 A30. C90."}) {
    const Toolpath path = path_of_program(program(before, "G43.4 H1\nG0 A30. C40."), "fanuc", setup);
    expect_tip(path.moves.back(), 11, 20, 30);
  }
}

// Until a joint turns, the tip is where it is without tool centre point control.
TEST(TipFrame, AtTheCallIsThatOfTheWorkOffset) {
  Scatter scatter(20261201);
  ProgramSetup setup = with_frame(TipFrame::table_at_call);
  setup.offsets["G54"].xyz_mm = Vec3(5, -7, 11);
  for (int i = 0; i < 40; ++i) {
    setup.offsets["G54"].abc_deg = i % 2 == 0 ? Vec3(0, 0, 0) : Vec3(0, 0, 25);
    const std::string before = "G0 A" + exact_text(scatter.in(-100, 100)) + " C" + exact_text(scatter.in(0, 350));
    const Toolpath of_tip = path_of_program(program(before, "G43.4 H1"), "fanuc", setup),
                   of_joints = path_of_program(program(before, "G43 H1"), "fanuc", setup);
    const Pose &found = of_tip.moves.back().end, &expected = of_joints.moves.back().end;
    ASSERT_TRUE(of_tip.moves.back().not_checked_reason.empty()) << of_tip.moves.back().not_checked_reason;
    ASSERT_TRUE(of_joints.moves.back().not_checked_reason.empty()) << of_joints.moves.back().not_checked_reason;
    EXPECT_LT((found.tip - expected.tip).norm(), 1e-9) << before;
    EXPECT_LT((found.axis - expected.axis).norm(), 1e-12) << before;
    const Toolpath turned = path_of_program(program(before, "G43.4 H1\nG0 A-10. C12."), "fanuc", setup);
    EXPECT_LT((turned.moves.back().end.tip - expected.tip).norm(), 1e-9) << "the frame turns with the table";
  }
}

TEST(TipFrame, AtTheCallNeedsATableThatStands) {
  const ProgramSetup setup = with_frame(TipFrame::table_at_call);
  expect_open(program("G0 A0. C90.", "G43.4 H1 G0 C0."), "fanuc", "in its own block", setup);
  expect_open(program("", "G43.4 H1"), "fanuc", "the positions of the rotary joints are not known", setup);
  expect_open(program("G0 A0. C90.", "G43.4 H1\nG68.2 X0. Y0. Z0. I0. J10. K0.\nG53.1"), "fanuc", "", setup);
}

TEST(TipFrame, IsNotKnownWithAWorkOffsetThatTurnsAJoint) {
  ProgramSetup setup = with_frame(TipFrame::table_at_zero);
  setup.offsets["G54"].abc_deg = Vec3(0, 0, 30);
  setup.offsets["G55"] = {};
  expect_open(program("G0 A0. C0.", "G43.4 H1"), "fanuc", "the work offset turns a rotary joint", setup);
  expect_open(program("G0 A0. C0.", "G234 H1"), "haas", "the work offset turns a rotary joint", setup);
  setup.tip_frame = TipFrame::table;
  expect_open(program("G0 A0. C0.", "G43.4 H1"), "fanuc", "table-at-zero or table-at-call", setup);
  expect_checked(program("G0 A0. C-30.", "G43.4 H1\nG0 C-30."), "fanuc", setup);
  setup.tip_frame = TipFrame::table_at_call;
  expect_open(program("G0 A0. C0.", "G43.4 H1\nG55"), "fanuc", "changes the work offset", setup);
}

}  // namespace
}  // namespace gouge::test::tip_frame_test
