// Programs that a careless reader would misread: none of them can be clean. Each number is that of a trap in the list of
// docs/formats/gcode.md. Where the missing fact is given, the same program is checked.
#include "lib/machine/linuxcnc_ini.h"
#include "tests/postproc/gcode/program.h"

namespace gouge::test::traps_test {
namespace {

constexpr const char* kFanucStart = "G21 G90 G17 G98\nT1 M6\nG43 H1\nG0 X0. Y0. Z10.\n";

ProgramSetup on(std::shared_ptr<const Machine> machine) {
  ProgramSetup setup;
  setup.machine = std::move(machine);
  return setup;
}

std::string fanuc(const std::string& blocks) { return kFanucStart + blocks + "M30\n"; }

// A tool without a number has the length of the first H, and every other H needs both lengths.
void expect_two_lengths_of_a_tool_without_number() {
  for (const char* control : {"fanuc", "haas", "linuxcnc"}) {
    for (const char* change : {"", "M0\n", "M6\n"}) {
      const std::string text =
          std::string("G21 G90 G17\nG43 H1 G0 X0. Y0. Z10.\n") + change + "G43 H2 G0 X0. Y0. Z10.\nG1 X5. F9.\nM30\n";
      expect_open(text, control, "no tool number is stated; expected T and M6");
      ProgramSetup setup;
      setup.lengths_mm = {{1, 100}, {2, 90}};
      const Toolpath path = path_of_program(text, control, setup);
      expect_tip(path.moves.back(), 5, 0, 0);
      expect_tip(path.moves.front(), 0, 0, 10);
    }
    expect_checked("G21 G90 G17\nG43 H1 G0 X0. Y0. Z10.\nG1 X5. F9.\nT2 M6\nG43 H2 G0 X0. Y0. Z10.\nG1 X5. F9.\nM30\n",
                   control);
  }
}

TEST(GcodeTraps, T01_CodesThatEndAnotherModeThanTheirs) {
  const std::string haas = "G20 G90 G17\nT1 M6\nG234 H1\nG0 X0. Y0. Z5. B0. C0.\nG1 B30. F9.\nG255\nG1 B40.\nM30\n";
  ProgramSetup setup = on(machine_of("haas-umc750"));
  expect_open(haas, "haas", "tool centre point control", setup);
  setup.tip_control_ends = {"G49"};
  expect_checked(haas, "haas", setup);
  const std::string turned = "G20 G90 G17\nT1 M6\nG43 H1\nG0 X0. Y0. Z5. B0. C0.\nG254\nG1 X1. F9.\nG49\nG0 B9.\nM30\n";
  expect_open(turned, "haas", "tool centre point control", on(machine_of("haas-umc750")));
}

TEST(GcodeTraps, T02_MissingOffsetLengthAndPivot) {
  const std::string two = "G21 G90 G54 G0 X0 Y0 Z0\nG1 X1 F9\nG55 X0 Y0 Z0\nM2\n";
  expect_open(two, "linuxcnc", "--offset G54");
  ProgramSetup both;
  both.offsets["G54"] = {};
  both.offsets["G55"].xyz_mm = {1, 2, 3};
  expect_checked(two, "linuxcnc", both);
  expect_open(fanuc("G49 G0 Z20.\nG1 X5. F9.\n"), "fanuc", "--tool-length");
  ProgramSetup length;
  length.tool_length_mm = 100;
  expect_checked(fanuc("G49 G0 Z20.\nG1 X5. F9.\n"), "fanuc", length);
  expect_open(fanuc("G43 H2\nG1 X5. F9.\n"), "fanuc", "H2 is applied to T1");
  expect_two_lengths_of_a_tool_without_number();
  const std::string turned = "G21 G90 G0 X0 Y0 Z0 A0 C0\nG1 A30 F9\nM2\n";
  expect_open(turned, "linuxcnc", "--joint-point", on(machine_of("linuxcnc-xyzac-trt")));
  expect_checked(turned, "linuxcnc", on(trunnion()));
  expect_open("G21 G90 G0 X0 Y0 Z0\nG53 G0 Z0\nM2\n", "linuxcnc", "--offset");
}

TEST(GcodeTraps, T03_UnknownCodesAndMacros) {
  for (const char* word : {"G65 P9100", "M200", "G999", "G12.1", "M60", "G200.1", "G1.5 X1", "G66", "M98"})
    expect_open(fanuc(std::string("G1 X5. F9.\n") + word + "\nG1 X6.\n"), "fanuc",
                word == std::string("M98") ? "" : "");
  const ReadOutcome told = read_program(fanuc("G1 X5. F9.\nM200\nG1 X6.\n"), "fanuc", {}, {"M200"});
  EXPECT_TRUE(can_be_clean(told)) << reasons_of(told);
  // The machine may move in a tool change: nothing is swept to the next position, and the coordinates must be stated.
  const ReadOutcome changed = read_program(fanuc("G1 X5. F9.\nT2 M6\nG43 H2\nG1 X6.\n"), "fanuc");
  EXPECT_FALSE(can_be_clean(changed)) << "Y and Z are not known after the change";
}

TEST(GcodeTraps, T04_TheLawOfG434) {
  ProgramSetup setup = on(trunnion());
  setup.tip_frame = TipFrame::table;
  const std::string program = "G21 G90 G17\nT1 M6\nG43.4 H1 P1 G0 X0. Y0. Z5. A0. C0.\nG1 A30. F9.\nM30\n";
  setup.feed_law = TurnLaw::axis;
  expect_open(program, "fanuc", "--feed-law vector", setup);
  setup.feed_law = TurnLaw::vector;
  expect_checked(program, "fanuc", setup);
  setup.feed_law = TurnLaw::documented;
  expect_checked(program, "fanuc", setup);
}

TEST(GcodeTraps, T05_CoordinatesThatDoNotTurnWithTheTable) {
  ProgramSetup setup = on(trunnion());
  setup.feed_law = TurnLaw::documented;
  const std::string program = "G21 G90 G17\nT1 M6\nG43.4 H1 G0 X0. Y0. Z5. A0. C0.\nG1 A30. F9.\nM30\n";
  expect_open(program, "fanuc", "--tip-frame", setup);
  setup.tip_frame = TipFrame::workpiece;
  expect_open(program, "fanuc", "do not turn with the table", setup);
}

TEST(GcodeTraps, T06_VectorsOfG435) {
  expect_open("G21 G90 G17\nT1 M6\nG43.5 H1\nG0 X0. Y0. Z5. I0. J0. K1.\nG1 X1. I1. F9.\nM30\n", "fanuc", "",
              on(trunnion()));
}

TEST(GcodeTraps, T07_ShiftsOfTheControl) {
  for (const char* word : {"G54.4 P1", "G54.2 P1", "G92 X0. Y0.", "G52 X5.", "G10 L2 P1 X5.", "G51.1 X0.", "G51 P500"})
    expect_open(fanuc(std::string(word) + "\nG1 X5. F9.\n"), "fanuc", "");
  for (const char* word : {"G92 X0", "G52 X5", "G10 L2 P1 X5", "G92.1", "G5.1"})
    expect_open(std::string("G21 G90 G0 X0 Y0 Z0\n") + word + "\nG1 X5 F9\nM2\n", "linuxcnc", "");
}

TEST(GcodeTraps, T08_RadiusCompensation) {
  expect_open(fanuc("G41 D1\nG1 X5. F9.\nG40 X0. Y0. Z0.\nG1 Z1.\n"), "fanuc", "compensated by the radius");
  const Toolpath path = path_of_program(fanuc("G41 D1\nG1 X5. F9.\nG40\nG1 X0. Y0. Z0.\nG1 Z1.\n"), "fanuc");
  EXPECT_EQ(path.moves.back().not_checked_reason, "") << "known again";
}

TEST(GcodeTraps, T09_SmoothingWithoutANumber) {
  const std::string open = "G21 G90 G64\nG0 X0 Y0 Z0\nG1 X5 F9\nM2\n";
  expect_open(open, "linuxcnc", "--tip-tolerance");
  const std::string small = "G21 G90 G64 P0.02\nG0 X0 Y0 Z0\nG1 X5 F9\nM2\n";
  expect_open(small, "linuxcnc", "0.02 mm");
  ProgramSetup told;
  told.tip_tolerance_mm = 0.02;
  expect_checked(small, "linuxcnc", told);
  told.tip_tolerance_mm = 0.01;
  expect_open(small, "linuxcnc", "0.02 mm", told);
  expect_checked("G21 G90 G61\nG0 X0 Y0 Z0\nG1 X5 F9\nM2\n", "linuxcnc");
  expect_open(fanuc("G5.1 Q1\nG1 X5. F9.\n"), "fanuc", "--tip-tolerance");
}

TEST(GcodeTraps, T10_SwitchesProbingAndVariablesOfTheControl) {
  const std::string skipped = fanuc("/G1 X5. F9.\nG1 Y5. F9.\n");
  expect_open(skipped, "fanuc", "--block-delete");
  ProgramSetup setup;
  for (const bool is_on : {false, true}) {
    setup.is_block_delete_on = is_on;
    const Toolpath path = path_of_program(skipped, "fanuc", setup);
    EXPECT_EQ(path.moves.size(), is_on ? 2u : 3u);
  }
  expect_open(fanuc("G31 Z-5. F9.\n"), "fanuc", "G31");
  expect_open(fanuc("G1 X#5021 F9.\n"), "fanuc", "the value of X");
  expect_open(fanuc("IF [#5021 GT 0] GOTO 9\nN9 G1 X5. F9.\n"), "fanuc", "condition");
  expect_checked(fanuc("M1\nG1 X5. F9.\n"), "fanuc");
}

TEST(GcodeTraps, T11_NumbersWithoutDecimalPoint) {
  const std::string program = fanuc("G1 X5000 F100.\n");
  expect_open(program, "fanuc", "--plain-numbers");
  ProgramSetup setup;
  setup.plain_numbers = PlainNumbers::increments;
  expect_tip(path_of_program(program, "fanuc", setup).moves.back(), 5, 0, 10);
  setup.plain_numbers = PlainNumbers::units;
  expect_tip(path_of_program(program, "fanuc", setup).moves.back(), 5000, 0, 10);
  expect_checked(fanuc("G1 X0 F100.\n"), "fanuc");
}

TEST(GcodeTraps, T12_DirectionsOfRotaryJoints) {
  const std::string program = "G21 G90 M428\nG0 X0 Y0 Z0 A30 C0\nM2\n";
  const Toolpath opposite = path_of_program(program, "linuxcnc", on(machine_of("linuxcnc-xyzac-trt"))),
                 by_standard = path_of_program(program, "linuxcnc", on(trunnion()));
  EXPECT_NEAR(opposite.moves[0].end.axis.y(), 0.5, 1e-12);
  EXPECT_NEAR(by_standard.moves[0].end.axis.y(), -0.5, 1e-12);
}

TEST(GcodeTraps, T13_Radians) {
  const Result<Machine> machine =
      read_linuxcnc_ini("m.ini",
                        "[KINS]\nKINEMATICS = xyzac-trt-kins\n[TRAJ]\nLINEAR_UNITS = mm\nANGULAR_UNITS = rad\n"
                        "[HAL]\nHALCMD = setp xyzac-trt-kins.conventional-directions 0\n");
  ASSERT_FALSE(machine.has_value());
  EXPECT_NE(machine.error().message.find("ANGULAR_UNITS"), std::string::npos);
}

TEST(GcodeTraps, T14_WordsOfOtherControls) {
  for (const char* block : {"L X+10 R0 FMAX", "M128", "TRAORI", "CYCLE832(0.01)", "FUNCTION TCPM F TCP", "A3=0.5 C3=1",
                            "PLANE RESET STAY", "X=5"}) {
    expect_open(fanuc(std::string("G1 X5. F9.\n") + block + "\nG1 X6.\n"), "fanuc", "");
    expect_open(std::string("G21 G90 G0 X0 Y0 Z0\n") + block + "\nG1 X6 F9\nM2\n", "linuxcnc", "");
  }
}

TEST(GcodeTraps, T15_TurnsBeyondHalfATurn) {
  ProgramSetup setup = on(trunnion());
  setup.tip_frame = TipFrame::table;
  setup.feed_law = TurnLaw::documented;
  const std::string program = "G21 G90 G17\nT1 M6\nG43.4 H1 G0 X0. Y0. Z5. A0. C0.\nG1 C270. F9.\nM30\n";
  expect_open(program, "fanuc", "--rotary-turns", setup);
  setup.winds_as_programmed = true;
  expect_checked(program, "fanuc", setup);
}

TEST(GcodeTraps, T16_LoopsWithoutAnEndAndUnknownSubprograms) {
  expect_open("G21 G90 G0 X0 Y0 Z0\no10 while [1]\n#1=5\no10 endwhile\nM2\n", "linuxcnc", "a loop may have no end");
  expect_open("G21 G90 G0 X0 Y0 Z0\no<gone> call\nG1 X1 F9\nM2\n", "linuxcnc", "is not defined before its call");
  expect_open("G21 G90 G0 X0 Y0 Z0\no#1 call\nG1 X1 F9\nM2\n", "linuxcnc", "label");
  expect_open("G21 G90 G0 X0 Y0 Z0\no1 if [#<_hal[a.b]>]\nG1 X1 F9\no1 endif\nM2\n", "linuxcnc", "");
  expect_open(fanuc("M98 P77\nG1 X5. F9.\n"), "fanuc", "O77");
  expect_open(fanuc("GOTO 5\nN5 G1 X5. F9.\nN5 G1 X6.\n"), "fanuc", "more than one");
}

TEST(GcodeTraps, T17_LengthsAreThoseToTheTip) {
  const Toolpath path = path_of_program(fanuc("G1 X5. F9.\n"), "fanuc");
  bool is_said = false;
  for (const Assumption& fact : path.assumptions)
    is_said = is_said || (fact.subject == Subject::frame && fact.evidence.find("of the tip") != std::string::npos);
  EXPECT_TRUE(is_said);
}

TEST(GcodeTraps, T18_StateAtTheStart) {
  const std::string program = "G21 G17\nT1 M6\nG43 H1\nG0 X0. Y0. Z5.\nG1 X1. F9.\nM30\n";
  expect_open(program, "fanuc", "--start G90");
  ProgramSetup setup;
  setup.start = "G90\n";
  expect_checked(program, "fanuc", setup);
  expect_open("G90 G21\nT1 M6\nG43 H1\nG0 X0. Y0. Z5.\nG2 X1. I0.5 F9.\nM30\n", "fanuc", "--start G17");
  expect_open("G90 G17\nT1 M6\nG43 H1\nG0 X0. Y0. Z5.\nG1 X1. F9.\nM30\n", "fanuc", "");
  expect_open("G90 G17 G21\nT1 M6\nG43 H1\nX0. Y0. Z5.\nM30\n", "fanuc", "motion code");
  expect_open("G90 G21 G0 X0 Y0 Z0\nG1 X1 F9\n", "linuxcnc", "");
}

TEST(GcodeTraps, RapidsOfSeveralAxesNeedTheirLaw) {
  expect_open(fanuc("G0 X5. Y5.\n"), "fanuc", "--joint-rapid-law");
  expect_checked(fanuc("G0 X5.\nG0 Y5.\n"), "fanuc");
  ProgramSetup setup;
  setup.are_joint_rapids_straight = true;
  expect_checked(fanuc("G0 X5. Y5.\n"), "fanuc", setup);
}

TEST(GcodeTraps, AToolChangeDoesNotApplyTheLengthOfTheNewTool) {
  expect_open("G21 G90 G17\nT1 M6\nG43\nG0 X0 Y0 Z9\nT2 M6\nG0 X0 Y0 Z9\nG1 X1 F9\nM2\n", "linuxcnc", "H1 is applied");
  expect_checked("G21 G90 G17\nT1 M6\nG43\nG0 X0 Y0 Z9\nT2 M6\nG43\nG0 X0 Y0 Z9\nG1 X1 F9\nM2\n", "linuxcnc");
}

TEST(GcodeTraps, AFeedNeedsItsStart) {
  expect_open("G21 G90 G17\nT1 M6\nG43 H1\nG0 X0 Y0\nG1 Z1 F9\nM2\n", "linuxcnc", "begins");
}

TEST(GcodeTraps, AWordTwiceOrInTwoMeaningsIsNotRead) {
  for (const char* block : {"G1 X1. X2. F9.", "G0 G1 X1.", "G90 G91 X1.", "G1 X1. G1", "G1 X1. H5 F9.",
                            "G1 X1. R2. F9.", "G4 P1 Z5.", "G17 G18", "G1 X1. E5 F9.", "G1 X1. F9. I2."}) {
    expect_open(fanuc(std::string(block) + "\n"), "fanuc", "");
  }
}

TEST(GcodeTraps, BlocksOutsideOfThePercentSigns) {
  expect_open("G0 X5 Y5 Z-50\n%\nG21 G90 G0 X0 Y0 Z0\nG1 X1 F9\n%\n", "linuxcnc", "percent");
  expect_checked("G21 G90 G0 X0 Y0 Z0\nG1 X1 F9\n%\n", "linuxcnc");
  expect_checked("a list of my programs\n%\nG21 G90 G0 X0 Y0 Z0\nG1 X1 F9\n%\n", "linuxcnc");
}

TEST(GcodeTraps, ARotaryWordNeedsItsMachine) {
  const ReadOutcome outcome = read_program("G21 G90 G0 X0 Y0 Z0 A30\nM2\n", "linuxcnc");
  ASSERT_EQ(outcome.errors.size(), 1u);
  EXPECT_EQ(outcome.errors[0].code, "gcode-machine");
  const ReadOutcome other = read_program("G21 G90 G0 X0 Y0 Z0 B30\nM2\n", "linuxcnc", on(trunnion()));
  ASSERT_EQ(other.errors.size(), 1u);
  EXPECT_EQ(other.errors[0].code, "gcode-machine");
}

}  // namespace
}  // namespace gouge::test::traps_test
