// Words whose meaning a parameter of the control states, or that a reader easily skips.
#include <algorithm>

#include "tests/postproc/gcode/program.h"

namespace gouge::test::words_test {
namespace {

constexpr const char* kStart = "G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG43 H1 G0 X0. Y0.\nZ80.\n";

std::string program(const std::string& blocks) { return kStart + blocks + "M30\n"; }

ProgramSetup on_trunnion() {
  ProgramSetup setup;
  setup.machine = trunnion();
  setup.offsets["G54"] = {};
  setup.lengths_mm = {{1, 100}};
  return setup;
}

TEST(GcodeWords, BesideTheNameOfAProgramAreNotSkipped) {
  for (const char* control : {"haas", "fanuc"}) {
    for (const char* name : {"O1000 G91", ":1000 G91", "O1000G91", "O1000 (A) G91", "<A> G91", "O1000 (A"})
      EXPECT_FALSE(can_be_clean(read_program(std::string(name) + "\n" + program("G1 X5. F9.\n"), control)))
          << name << " on " << control;
    expect_open(program("M98 P2000\n") + "O2000 G91\nG1 X5. F9.\nM99\n", control, "'G91' stands in the block");
    for (const char* name : {"O1000", ":1000", "O1000 (A) (B)", "<A>", "o 1000", "O1000 Final part"})
      expect_checked(std::string(name) + "\n" + program("G1 X5. F9.\n"), control);
  }
}

TEST(GcodeWords, WithTwoSignsAreNumbersOnLinuxcncAlone) {
  for (const char* word : {"X--5.", "X+-5.", "X-+5.", "X - - 5."}) {
    const std::string text = program(std::string("G1 ") + word + " F9.\n");
    for (const char* control : {"haas", "fanuc"}) expect_open(text, control, "two signs");
  }
  expect_tip(path_of_program(program("G1 X--5. F9.\n"), "linuxcnc").moves.back(), 5, 0, 80);
}

TEST(GcodeWords, OfRangesThatAParameterChoosesAreOpen) {
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(program("#1=ASIN[-0.5]\nG1 X#1 F9.\n"), control, "the value of X");
    const Toolpath path = path_of_program(program("#1=ASIN[0.5]\nG1 X#1 F9.\n"), control);
    EXPECT_NEAR(path.moves.back().end.tip.x(), 30, 1e-9);
  }
  EXPECT_NEAR(path_of_program(program("#1=ASIN[-0.5]\nG1 X#1 F9.\n"), "linuxcnc").moves.back().end.tip.x(), -30, 1e-9);
}

// Fanuc, B-63324EN and B-64484EN, custom macro: relations and FIX take the rounding of the control; FIX[0.002*1000] may be 1.
TEST(GcodeWords, WhoseValueDependsOnRoundingAreOpen) {
  const auto fix = [](const std::string& value) {
    return program("#1=0.002\n#2=#1*1000\n#3=" + value + "\nG1 X#3 F9.\n");
  };
  for (const char* control : {"haas", "fanuc"}) {
    for (const char* value : {"FIX[#2]", "FUP[#2]", "FIX[0.1*30]", "FUP[0.1*3*10]", "ROUND[0.285*100]", "[0.3MOD0.1]"})
      expect_open(fix(value), control, "the value of X");
    for (const char* value : {"FIX[20/10]", "FIX[2.5]", "FUP[7/2]", "ROUND[2.4]", "FIX[#2+0.5]", "[7MOD2]"})
      expect_checked(fix(value), control);
    for (const char* relation : {"LE", "LT", "GE", "GT", "EQ", "NE"})
      expect_open(program(std::string("#1=0.1+0.1+0.1\nIF [#1 ") + relation + " 0.3] GOTO 5\nG1 X1. F9.\nN5\n"),
                  control, "a condition whose value is not known");
    expect_checked(program("#1=3\nWHILE [#1 GT 0] DO1\nG1 X#1 F9.\n#1=#1-1\nEND1\n"), control);
  }
}

// Fanuc, B-64484EN: in an address ROUND rounds to its least increment.
TEST(GcodeWords, RoundToAnIncrementInAddressesOfMacros) {
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(program("#1=7.45\nG1 X[ROUND[#1]] F9.\n"), control, "the value of X");
    expect_open(program("#1=7.45\nG1 X[1.+ROUND[#1]] F9.\n"), control, "the value of X");
    expect_tip(path_of_program(program("#1=ROUND[7.45]\nG1 X#1 F9.\n"), control).moves.back(), 7, 0, 80);
  }
  expect_tip(path_of_program(program("#1=7.45\nG1 X[ROUND[#1]] F9.\n"), "linuxcnc").moves.back(), 7, 0, 80);
}

// Fanuc, B-63534EN, 20.2.2: a parameter lets the sign of the word state the direction.
TEST(GcodeWords, OfRollOverAxesMayStateTheDirectionByTheirSign) {
  const std::string start = "G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG0 A0. C10.\nX0. Y0.\nG43 H1 Z80.\n";
  const auto text = [&](const std::string& word) { return start + "G1 " + word + " F9.\nM30\n"; };
  for (const char* word : {"C-30.", "C5.", "C190."})
    expect_open(text(word), "fanuc", "may change the turn of C", on_trunnion());
  for (const char* word : {"C60.", "C10.", "A-30.", "A30.", "G91 C-5."})
    expect_checked(text(word), "fanuc", on_trunnion());
  for (const char* word : {"C-30.", "C5.", "A-30."}) expect_checked(text(word), "haas", on_trunnion());
  ProgramSetup stated = on_trunnion();
  stated.winds_as_programmed = true;
  expect_checked(text("C-30."), "fanuc", stated);
}

TEST(GcodeWords, ChooseTheFirstWorkOffsetInPlaceOfThatOfTheStart) {
  for (const char* control : {"haas", "fanuc"}) {
    const std::string start = "G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG43 H1\n";
    expect_checked(start + "G0 G55 X0. Y0.\nZ5.\nG1 X5. F9.\nM30\n", control);
    expect_open(start + "G0 X0. Y0.\nZ5.\nG55 G1 X5. F9.\nM30\n", control, "changes from work offset G54 to G55");
  }
}

// Fanuc, B-64484EN, 7.1: the tool goes to a place of the machine by rapid traverse, also under G1.
TEST(GcodeWords, OfMachinePlacesAreRapids) {
  const std::string text = program("G1 Z70. F9.\nG53 X-20. Y-20.\n");
  ProgramSetup setup;
  setup.offsets["G54"] = {Vec3(30, 20, -300), Vec3::Zero()};
  setup.tool_length_mm = 100;
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(text, control, "how several axes run in a rapid", setup);
    const Toolpath path = path_of_program(program("G1 Z70. F9.\nG53 X-20.\n"), control, setup);
    EXPECT_EQ(path.moves.back().kind, MoveKind::rapid) << control;
  }
  EXPECT_EQ(path_of_program(text, "linuxcnc", setup).moves.back().kind, MoveKind::feed);
}

// Haas, Mill Operator's Manual, "Looping canned cycles": G81 Z-1.5 R.1, then G91 X1.0 L9: all holes have this depth.
TEST(GcodeWords, OfACycleKeepTheModeInWhichTheyStand) {
  const auto lowest = [](const std::string& text, const char* control) {
    double low = 0;
    for (const Move& move : path_of_program(text, control).moves)
      if (move.end.tip.x() > 15) low = std::min(low, move.end.tip.z());
    return low;
  };
  const std::string start = "G21 G90 G17 G40 G49 G80 G94 G54 G98\nT1 M6\nG43 H1 G0 X0. Y0. Z30.\nF200.\nG0 Z20.\n";
  const std::string text = start + "G81 X0. Y0. Z-15. R-5.\nG91 X10.\nX10.\nG90 G80\nM30\n";
  for (const char* control : {"haas", "fanuc"}) {
    EXPECT_NEAR(lowest(text, control), -15, 1e-9) << control;
    expect_open(start + "G91 G81 X0. Y0. Z-10. R-5.\nG90 X10.\nG80\nM30\n", control, "is a step of G91");
    expect_open(start + "G81 X0. Y0. Z-10. R-5.\nG91 X10. Z-2.\nG80\nM30\n", control, "is a step of G91");
    expect_checked(start + "G91 G81 X0. Y0. Z-10. R-5.\nX10.\nG80\nM30\n", control);
  }
}

// Fanuc, B-64484EN: of several codes of group 00 the last counts; LinuxCNC refuses them.
TEST(GcodeWords, OfOneBlockExcludeEachOtherInGroupZero) {
  ProgramSetup setup;
  setup.offsets["G54"] = {};
  setup.tool_length_mm = 100;
  setup.home_mm = Vec3(0, 0, 300);
  for (const char* control : {"linuxcnc", "haas", "fanuc"})
    for (const char* codes : {"G28 G53 Z20.", "G53 G9 Z20.", "G28 G30 Z20.", "G4 P1. G53 Z20."})
      EXPECT_FALSE(can_be_clean(read_program(program(std::string(codes) + "\nG1 X5. F9.\n"), control, setup)))
          << codes << " on " << control;
}

// A word that neither moves nor changes anything has no coordinates.
TEST(GcodeWords, ThatTheUserStatesAreNoMotion) {
  for (const char* control : {"linuxcnc", "haas", "fanuc"}) {
    for (const char* code : {"G200", "M200"}) {
      const std::vector<std::string> harmless = {code};
      EXPECT_TRUE(can_be_clean(read_program(program(std::string(code) + "\nG1 X5. F9.\n"), control, {}, harmless)));
      EXPECT_FALSE(
          can_be_clean(read_program(program(std::string(code) + " X3. Y4.\nG1 X5. F9.\n"), control, {}, harmless)))
          << code << " on " << control;
    }
  }
}

// Whatever a damaged file holds, the reader ends with a reason.
TEST(GcodeWords, InEachOtherAreBounded) {
  for (const char* control : {"linuxcnc", "haas", "fanuc"}) {
    for (const char* part : {"-", "#", "#[", "[", "-#", "SIN["}) {
      std::string word = "G1 X";
      for (int i = 0; i < 100000; ++i) word += part;
      EXPECT_FALSE(can_be_clean(read_program(program(word + "1. F9.\n"), control))) << part << " on " << control;
    }
  }
}

// LinuxCNC keeps the numbers of R and Z, not their lengths; no manual at hand states it for the others.
TEST(GcodeWords, OfUnitsInACycleAreNotRead) {
  const std::string start =
      "G20 G90 G17 G40 G49 G80 G94 G54 G98\nT1 M6\nG43 H1 G0 X0. Y0. Z1.\nF4.\nG81 X.4 Y0. Z.2 R.4\n";
  for (const char* control : {"linuxcnc", "haas", "fanuc"}) {
    expect_open(start + "G21\nX20.\nG80\nM30\n", control, "the unit is stated while a cycle is in force");
    expect_checked(start + "G80\nG21\nG0 X20.\nM30\n", control);
  }
}

TEST(GcodeWords, OfCallsAndDwellsMayStandInACycle) {
  const std::string text = program("G99 G81 X10. Y0. Z-5. R2. F100.\nM98 P2000\nG4 P500\nG80\n") + "O2000\nX20.\nM99\n";
  for (const char* control : {"haas", "fanuc"}) expect_checked(text, control);
}

TEST(GcodeWords, OfBlocksThatAreCalledAreOfTheProgramThatRuns) {
  const std::string text =
      "O1\n" + program("M97 P100\nM98 P2\n") + "N100 G1 X7. F9.\nM99\nO2\nM97 P100\nM99\nN100 G1 X8. F9.\nM99\n";
  expect_tip(path_of_program(text, "haas").moves.back(), 8, 0, 80);
  expect_open("O1\n" + program("M97 P100\n") + "O2\nG1 X9.\nM99\nN100 X7.\nM99\n", "haas", "has the number N100");
}

TEST(GcodeWords, OfAFileBesideAreThoseOfTheCalledProgram) {
  ProgramSetup setup;
  setup.read_beside = [](const std::string& name) -> std::vector<std::string> {
    if (name == "O2000") return std::vector<std::string>{"O1999\nX9.\nM99\nO2000\nG1 X7. F9.\nM99\n"};
    if (name == "O3000") return std::vector<std::string>{"O3001\nX9.\nM99\n"};
    if (name == "O4000") return std::vector<std::string>{"G1 X4. F9.\nM99\n"};
    return {};
  };
  for (const char* control : {"haas", "fanuc"}) {
    const auto call = [](const char* word) { return program(std::string("M98 ") + word + "\n"); };
    expect_tip(path_of_program(call("P2000"), control, setup).moves.back(), 7, 0, 80);
    expect_tip(path_of_program(call("P4000"), control, setup).moves.back(), 4, 0, 80);
    expect_open(call("P3000") + "", control, "holds another program", setup);
  }
}

TEST(GcodeWords, OfACallThatMayMeanTwoProgramsAreNotRead) {
  ProgramSetup one, two;
  one.read_beside = [](const std::string&) { return std::vector<std::string>{"G1 X4. F9.\nM99\n"}; };
  two.read_beside = [](const std::string&) { return std::vector<std::string>{"G1 X4.\nM99\n", "G1 X5.\nM99\n"}; };
  for (const char* control : {"haas", "fanuc"}) {
    expect_checked("O1\n" + program("M98 P2\n"), control, one);
    expect_open("O1\n" + program("M98 P2\n") + "O2\nG1 X7. F9.\nM99\n", control, "is in the file and beside it", one);
    expect_open("O1\n" + program("M98 P2\n"), control, "several files beside the program are called O2", two);
  }
}

TEST(GcodeWords, BesideTheValueOfAVariableAreNotRead) {
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(program("#1=5.\n#1=#1+95. G1 X#1 F9.\n"), control, "#1 is set in a block with other words");
    expect_open(program("#1=5.\n#1=9. #2=#1\nG1 X#2 F9.\n"), control, "not known");
    expect_checked(program("#1=5. #2=6.\nG1 X#2 F9.\n"), control);
  }
}

// On a control with program numbers of four digits, P30100 is three times O0100.
TEST(GcodeWords, OfACallMayCountItsRepeatsOnFanuc) {
  const std::string subs = "O100\nG91 G1 X1. F9.\nG90\nM99\nO30100\nG1 X7. F9.\nM99\n";
  for (const char* call : {"M98 P30100", "M98 P00030100", "M98 P00000100", "M98 P00100", "M98 P30100.",
                           "M98 P[30000+100]", "#1=30100\nM98 P#1", "M98 P30100 L2"})
    expect_open("O1\n" + program(std::string(call) + "\n") + subs, "fanuc", "more than 4 digits");
  for (const char* call : {"M98 P100", "M98 P0100", "M98 P 0100", "M98 P[50+50]", "#101=100\nM98 P#101"})
    expect_tip(path_of_program("O1\n" + program(std::string(call) + "\n") + subs, "fanuc").moves.back(), 1, 0, 80);
  expect_tip(path_of_program("O1\n" + program("M98 P30100\n") + subs, "haas").moves.back(), 7, 0, 80);
}

TEST(GcodeWords, InCommentsAreStatementsOfPythonOnLinuxcnc) {
  for (const char* comment : {";py,self.execute(\"g1 x10\")", "(py,x=1)", "; PYRUN,f", ";pyreload"})
    expect_open(program(std::string(comment) + "\nG1 X5. F9.\n"), "linuxcnc", "Python");
  for (const char* comment : {"; python", "(pyramid, rough)"})
    expect_checked(program(std::string(comment) + "\nG1 X5. F9.\n"), "linuxcnc");
}

// Without G43 the length is in the work offset, along its Z: no control then knows the tip of a tool that it turns.
TEST(GcodeWords, OfLengthsAreNeededWhereTheControlTurnsTheTool) {
  ProgramSetup setup;
  setup.machine = trunnion();
  setup.are_joint_rapids_straight = true;
  const auto line_of_frame = [&](const std::string& text, const char* control) {
    const ReadOutcome outcome = read_program(text, control, setup);
    for (const Assumption& fact : path_in(outcome, text).assumptions)
      if (fact.subject == Subject::frame) return fact.basis == Basis::unknown ? fact.line : 0;
    return std::size_t{0};
  };
  const std::string start = "G21 G90 G17 G94 G40 G49 G80\nT1 M6\nG0 A0. C0.\nX0. Y0.\nZ90.\n";
  EXPECT_EQ(line_of_frame(start + "M428\nG1 X10 F9\nM2\n", "linuxcnc"), 0U);
  EXPECT_EQ(line_of_frame(start + "M428\nG1 X10 A30 F9\nM2\n", "linuxcnc"), 7U);
  EXPECT_EQ(line_of_frame("G21 G90\nT1 M6\nG43 H1\nG0 A0 C0\nX0 Y0\nZ90\nM428\nG1 X10 A30 F9\nM2\n", "linuxcnc"), 0U);
  EXPECT_EQ(line_of_frame(start + "G1 X10 A30 F9\nM2\n", "linuxcnc"), 0U) << "the table turns, and the tool stands";
  EXPECT_EQ(line_of_frame(start + "A30.\nG254\nG1 X10. F9.\nM30\n", "haas"), 8U);
}

// In a tilted frame the control applies another length along the tool.
TEST(GcodeWords, OfOtherLengthsAreNotReadInATiltedFrame) {
  ProgramSetup setup = on_trunnion();
  setup.lengths_mm = {{1, 100}, {4, 130}};
  setup.are_joint_rapids_straight = true;
  const std::string start = "G21 G90 G17 G94 G40 G49 G80\nT1 M6\nG0 A0. C0.\nX0. Y0.\nG43 H1 Z90.\n";
  for (const auto& [length, is_read] : {std::pair("H4", false), std::pair("H1", true)}) {
    const std::string text =
        start + "G68.2 X0. Y0. Z0. I0. J30. K0.\nG53.1\nG43 " + length + " X0. Y0. Z50.\nG1 Z40. F9.\nM30\n";
    const std::string reasons = reasons_of(read_program(text, "fanuc", setup));
    EXPECT_EQ(reasons.find("9: the length that is applied in a tilted frame") == std::string::npos, is_read) << reasons;
  }
}

// No manual at hand states how far rotary joints leave their turns.
TEST(GcodeWords, ThatRoundCornersRoundTheTurnsOfJointsToo) {
  ProgramSetup setup;
  setup.machine = trunnion();
  setup.tip_tolerance_mm = 0.1;
  const std::string start = "G21 G90 G17\nT1 M6\nG43 H1\nG0 A0 C0\nX0 Y0 Z90\nM428\nG64 P0.1\nG1 X5 F9\nX6\n";
  const auto lines_open = [&](const std::string& blocks) {
    std::string lines;
    for (const Move& move : path_of_program(start + blocks + "M2\n", "linuxcnc", setup).moves)
      if (!move.not_checked_reason.empty()) lines += std::to_string(std::size_t{move.line}) + " ";
    return lines;
  };
  EXPECT_EQ(lines_open("X7\n"), "");
  EXPECT_EQ(lines_open("X7 A30\nX8\n"), "9 10 11 ");
  EXPECT_EQ(lines_open("G61 X7 A30\nX8\n"), "");
  setup.axis_tolerance_rad = 0.01;
  EXPECT_EQ(lines_open("X7 A30\nX8\n"), "");
}

// The laws joint and independent are those of joints without tool centre point control.
TEST(GcodeWords, OfTipControlAreNotCheckedByALawWithoutIt) {
  ProgramSetup setup;
  setup.machine = trunnion();
  const std::string text = "G21 G90 G17 G61\nT1 M6\nG43 H1\nG0 A0 C0\nX0 Y0 Z90\nM428\nG1 X5 A30 F9\nM2\n";
  for (const TurnLaw law : {TurnLaw::joint, TurnLaw::independent, TurnLaw::axis}) {
    setup.laws = TurnLaws{law, TurnLaw::axis, TurnLaw::joint};
    EXPECT_EQ(can_be_clean(read_program(text, "linuxcnc", setup)), law == TurnLaw::axis);
  }
}

// A part zero and an offset in machine coordinates leave no room for a length in the offset.
TEST(GcodeWords, OfLengthsAreNeededBesideAPartZero) {
  ProgramSetup setup;
  setup.zero = RigidTransform{Eigen::Matrix3d::Identity(), Vec3(0, 0, -300)};
  setup.machine = std::make_shared<const Machine>(place_part(*trunnion(), *setup.zero));
  setup.offsets["G54"] = {Vec3(0, 0, -200), Vec3::Zero()};
  const std::string text = "G21 G90 G17 G94 G40 G49 G80\nT1 M6\nG0 A0. C0.\nX0. Y0.\nZ90.\nG1 X10. F9.\nM30\n";
  EXPECT_FALSE(can_be_clean(read_program(text, "haas", setup)));
  setup.tool_length_mm = 100;
  const Toolpath path = path_of_program(text, "haas", setup);
  EXPECT_NEAR(path.moves.back().end.tip.z(), 90 - 200 - 100 + 300, 1e-9);
}

TEST(GcodeWords, ThatDoNotRunAreNoted) {
  const auto notes = [](const std::string& text, const std::string& control) {
    std::string all;
    for (const Diagnostic& note : path_of_program(text, control).notes)
      if (note.code == "gcode-not-run") all += to_text(note);
    return all;
  };
  const std::string runs = program("G1 X5. F9.\n");
  for (const char* control : {"linuxcnc", "haas", "fanuc"}) {
    EXPECT_EQ(notes("%\n" + runs + "%\n(text)\n", control), "") << control;
    EXPECT_NE(notes(runs + "G1 Z-5.\nM30\n", control).find("2 blocks do not run"), std::string::npos) << control;
  }
  EXPECT_EQ(notes(program("M98 P2 L2\n") + "O2\nG1 X5. F9.\nM99\n", "haas"), "");
  const std::string block = "G17 G71 G90 G60 G54 G94 D1\nG0 X0 Y0 Z9\nM30\n";
  EXPECT_NE(notes("%_N_A_MPF\n" + block + "%_N_B_SPF\n" + block, "siemens").find(":6: note: 3 blocks"),
            std::string::npos);
  for (const char* first : {"%_N_A_MPF\n", "%_N_A_SPF\n"})
    EXPECT_NE(
        reasons_of(read_program(first + block + "%_N_B_MPF\n" + block, "siemens")).find("an archive with another"),
        std::string::npos);
  EXPECT_EQ(notes("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1\n2 L X+0 Y+0 Z+9 R0 FMAX M30\n3 END PGM A MM\n", "heidenhain"),
            "");
}

/// Returns the fact about the frame of a program.
Assumption frame_in(const std::string& text, const ProgramSetup& setup = {}) {
  for (const Assumption& fact : path_of_program(text, "haas", setup).assumptions)
    if (fact.subject == Subject::frame) return fact;
  ADD_FAILURE() << text;
  return {};
}

TEST(GcodeWords, OfALengthAreMissedWhereAToolIsLoaded) {
  const std::string start = "G17 G21 G90 G94 G40 G80 G98\n", moves = "G0 X0. Y0. Z50.\nG1 X5. F9.\nM30\n";
  const Assumption forgotten = frame_in(start + "T1 M6\n" + moves);
  EXPECT_EQ(forgotten.basis, Basis::unknown);
  EXPECT_EQ(forgotten.evidence, "the program loads a tool and applies no tool length");
  EXPECT_NE(forgotten.remedy.find("G43"), std::string::npos);
  EXPECT_EQ(frame_in(start + "T1 M6\nG43 H1\n" + moves).basis, Basis::by_default);
  EXPECT_EQ(frame_in(start + moves).basis, Basis::by_default) << "the one tool of a simple machine";
}

TEST(GcodeWords, OfAFirstPlaceNameWhatMakesItUnknown) {
  const ReadOutcome outcome =
      read_program("G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG43 H1\nG0 X-10 Y5 Z20\nG1 Z0 F500\nM30\n", "haas");
  EXPECT_NE(reasons_of(outcome).find("--plain-numbers"), std::string::npos) << reasons_of(outcome);
}

TEST(GcodeWords, MayFollowAByteOrderMark) {
  const std::string mark = "\xef\xbb\xbf";
  for (const char* const control : {"linuxcnc", "haas", "fanuc"}) {
    EXPECT_TRUE(can_be_clean(read_program(mark + program("G1 X5. F9.\n"), control))) << control;
    EXPECT_TRUE(can_be_clean(read_program(mark + "%\n" + program("G1 X5. F9.\n") + "%\n", control))) << control;
  }
  const std::string wide(
      "\xff\xfeG\0"
      "1\0\n\0",
      8);
  EXPECT_NE(reasons_of(read_program(wide, "haas")).find("UTF-16"), std::string::npos);
}

TEST(GcodeWords, OfAToolBesideM6AreOpenOnFanucWhileAnotherToolIsWaiting) {
  const std::string change = "T3\nM6 T1\nG43 H1 G0 X0. Y0. Z50.\nG1 X5. F9.\n";
  expect_open(program(change), "fanuc", "T1 stands beside M6 while T3 is waiting");
  EXPECT_TRUE(can_be_clean(read_program(program(change), "haas")));
  for (const char* const usual : {"T1\nM6\n", "T3\nM6 T3\n", "T1 M6\nT2\nM6 T2\n", "T1 M6\nT2 M6\n"})
    EXPECT_TRUE(
        can_be_clean(read_program(program(std::string(usual) + "G43 G0 X0. Y0. Z50.\nG1 X5. F9.\n"), "linuxcnc")))
        << usual;
}

TEST(GcodeWords, GiveEachToolItsLengthAndDiameter) {
  ProgramSetup setup;
  setup.lengths_mm = {{1, 100}, {2, 60}};
  setup.diameters_mm = {{2, 12}};
  setup.tool_table = "l.tbl";
  const Toolpath path = path_of_program(program("T2 M6\nG43 H2 G0 X0. Y0.\nZ9.\nG1 X5. F9.\n"), "haas", setup);
  ASSERT_EQ(path.tools.size(), 2U);
  EXPECT_EQ(path.tools[0].gauge_length_mm, 100);
  EXPECT_EQ(path.tools[1].gauge_length_mm, 60);
  EXPECT_EQ(path.tools[0].stated_diameter_mm, 0);
  EXPECT_EQ(path.tools[1].stated_diameter_mm, 12);
  EXPECT_EQ(path.tools[1].in_table.file, "l.tbl");
  EXPECT_TRUE(path.tools[1].in_table.has_diameter);
  EXPECT_FALSE(path.tools[0].in_table.has_diameter);
}

TEST(GcodeWords, OfNegativeLengthsStateDifferencesAlone) {
  ProgramSetup setup;
  setup.lengths_mm = {{1, 100}, {2, -60}};
  const std::string text = program("T2 M6\nG43 H2 G0 X0. Y0.\nZ9.\nG1 X5. F9.\n");
  expect_checked(text, "haas", setup);
  for (const PathTool& tool : path_of_program(text, "haas", setup).tools) EXPECT_FALSE(tool.gauge_length_mm);
  const Toolpath other = path_of_program(program("T2 M6\nG43 H1 G0 X0. Y0.\nZ9.\n"), "haas", setup);
  EXPECT_NEAR(other.moves.back().end.tip.z(), 9 + 160, 1e-9) << "the difference of both lengths";
  expect_open(program("G49\nG0 Z90.\n"), "haas", "--tool-lengths has a negative length", setup);
  setup.lengths_mm[2] = 60;
  expect_checked(program("G49\nG0 Z90.\n"), "haas", setup);
}

// Fanuc B-63944EN, Logical expressions; Haas, Macros, Round off: a calculated value may be on either side of a limit that
// doubles meet exactly.
TEST(GcodeWords, LimitsThatCalculatedValuesMeetAreOpen) {
  const auto jump = [](const std::string& before, const std::string& condition) {
    return program(before + "IF [" + condition + "] GOTO 5\nG1 X1. F9.\nN5\n");
  };
  const auto value = [](const std::string& text) { return program("#3=" + text + "\nG1 X#3 F9.\n"); };
  for (const std::string control : {"haas", "fanuc"}) {
    for (const char* condition : {"#2 LT 1", "#2 GE 1", "#2 EQ 1", "#2 NE 1"})
      expect_open(jump("#2=[1/3]*3\n", condition), control, "a condition whose value is not known");
    for (const char* condition : {"0.1*10 EQ 1", "EXP[LN[2]] GE 2", "SIN[90] EQ 1", "SQRT[4] GT 2", "0.1+0.1 EQ 0.2"})
      expect_open(jump("", condition), control, "a condition whose value is not known");
    expect_open(program("#1=0\nWHILE [#1 LT 0.5] DO1\n#1=#1+0.1\nG1 X#1 F9.\nEND1\n"), control, "condition");
    for (const char* text : {"[[1/3]*3*10] MOD 10", "[[1/3]*3] AND 1", "[1/3*1000000000]-333333333",
                             "123456789.5-123456789", "12345678912+1-12345678912"})
      expect_open(value(text), control, "the value of X");
    for (const char* condition : {"#2 LT 1", "#2 EQ 0.1", "#2 NE 0.3", "[#2+1] GT 1.05"})
      expect_checked(jump("#2=0.1\n", condition), control);
    for (const char* condition : {"#2 EQ 0.75", "#2 GE 0.75", "[#2*4] EQ 3", "[#2 GT 0.5] AND [#2 LT 1]"})
      expect_checked(jump("#2=0.5+0.25\n", condition), control);
    expect_checked(program("#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+0.25\nG1 X#1 F9.\nEND1\n"), control);
    for (const char* text : {"12.7-12.7", "2000000-1999990", "7 MOD 4"}) expect_checked(value(text), control);
  }
}

// Haas, G81: L holes under G91; Fanuc: K. The joint may turn before each of them, and where it is afterwards is not known.
TEST(GcodeWords, RepeatedCyclesDoNotTurnJoints) {
  for (const std::string control : {"haas", "fanuc"}) {
    const std::string repeats = control == "haas" ? "L2" : "K2";
    const std::string cycle = "G0 A0. C0.\nX20. Y0. Z30.\nG99 G81 Z5. R10. F50.\nG91 ";
    const ProgramSetup setup = on_trunnion();
    expect_open(program(cycle + "C90. " + repeats + "\nG80\n"), control,
                "a repeated cycle has a step of a rotary joint", setup);
    expect_open(program(cycle + "C90. " + repeats + "\nG80\nG90 G1 X5. F9.\n"), control, "", setup);
    expect_open(program(cycle + "X2. C90. " + repeats + "\nG80\n"), control, "a repeated cycle", setup);
  }
}

// A mark of a loop in a comment is none, and one behind a slash may not be there.
TEST(GcodeWords, MarksOfLoopsAreThoseOfBlocks) {
  for (const std::string control : {"haas", "fanuc"}) {
    const Toolpath path = path_of_program(
        program("#1=0\nWHILE [#1 LT 2] DO1\n#1=#1+1\n(WHILE [#1 LT 9] DO1)\nN7 END1\nG1 X#1 F9.\n"), control);
    ASSERT_FALSE(path.moves.empty());
    EXPECT_DOUBLE_EQ(path.moves.back().end.tip.x(), 2) << control;
    EXPECT_TRUE(path.moves.back().not_checked_reason.empty()) << control;
    expect_open(program("#1=9\nWHILE [#1 LT 2] DO1\n#1=1\n/END1\nG1 X#1 F9.\nEND1\n"), control,
                "that a switch of the control may leave out");
    expect_open(program("#1=0\n/WHILE [#1 LT 2] DO1\n#1=#1+1\nEND1\nG1 X#1 F9.\n"), control, "");
  }
}

TEST(GcodeWords, OfFeedsWithoutADecimalPointAreNotedOnce) {
  const std::string text = program("G1 Z5. F500\nX2. F600\nG1 X3. F700.\n");
  const ReadOutcome outcome = read_program(text, "haas");
  EXPECT_TRUE(can_be_clean(outcome)) << reasons_of(outcome);
  const std::string note = "the feed rate is not known from here on: F500 has no decimal point";
  const std::string reasons = reasons_of(outcome);
  EXPECT_NE(reasons.find(note), std::string::npos) << reasons;
  EXPECT_EQ(reasons.find("F600"), std::string::npos) << reasons;
}

TEST(GcodeWords, ThatAreUnknownAreNamedAllAtOnce) {
  const std::string text =
      "G21 G90 G17\nT1 M6\nG43 H1 G0 X1. Y1.\nZ9.\nG1 Z5. F100.\nX9.\nM777\nG1 X2.\nM888\nM777\nG1 X3.\nG0 Z5.\nM999\nM2\n";
  const Toolpath path = test::path_of_program(text, "haas");
  const auto fact = std::ranges::find(path.assumptions, Subject::statements, &Assumption::subject);
  ASSERT_NE(fact, path.assumptions.end());
  EXPECT_EQ(fact->evidence,
            "not understood: line 7: M777 is not in the table of control Haas, line 9: M888 is not in the table of "
            "control Haas, line 13: M999 is not in the table of control Haas");
  std::string many = "G21 G90 G17\nT1 M6\nG43 H1 G0 X1. Y1.\nZ9.\nG1 Z5. F100.\nX9.\n";
  for (int k = 300; k < 400; ++k) many += "M" + std::to_string(k) + "\n";
  EXPECT_EQ(test::path_of_program(many + "M2\n", "haas").words_not_understood.size(), 20U);
  const ReadOutcome none = test::read_program("G21 G90 G17\nM777\nM888\nG1 X2. F100.\nM2\n", "haas");
  ASSERT_FALSE(none.toolpath);
  EXPECT_NE(
      none.errors.at(0).message.find("M777 is not in the table of control Haas; also not understood: line 3: M888"),
      std::string::npos)
      << none.errors.at(0).message;
}

}  // namespace
}  // namespace gouge::test::words_test
