#include "tests/postproc/gcode/siemens/siemens_program.h"

// What a careless reader would misread is not clean, with its line and a reason.

namespace gouge::siemens_traps_test {
namespace {

using test::expect_open;
using test::full_setup;
using test::kHead;

TEST(SiemensTraps, WordsWithoutARowEndTheKnowledge) {
  for (const char* block : {"G58 X1",
                            "G59 X1",
                            "G110 X1",
                            "G147",
                            "G33 Z1 K1",
                            "ROTS X10 Y10",
                            "TOFRAME",
                            "PAROT",
                            "CYCLE977(1)",
                            "POCKET3(1,2)",
                            "HOLES1(1,2)",
                            "LONGHOLE(1)",
                            "MEAS=1 X5",
                            "$P_UIFR[1]=CTRANS(X,5)",
                            "$AC_TIMER[1]=0",
                            "PRESETON(X,0)",
                            "TANG(C,X)",
                            "ASPLINE",
                            "POLY",
                            "CT X5 Y5",
                            "POS[X]=5",
                            "POSA[X]=5",
                            "M66",
                            "M27",
                            "H5",
                            "EXTCALL \"A\"",
                            "CALL \"A\"",
                            "CASE R1 OF 1 GOTOF A",
                            "DEF FRAME F1",
                            "LEAD=5",
                            "TILT=5",
                            "A2=5",
                            "A4=1",
                            "ORIRESET(0,0)",
                            "OEMIPO1",
                            "TOROT",
                            "WAITM(1,1)",
                            "ID=1 DO M5",
                            "XYZ=5",
                            "U5",
                            "G=1",
                            "G[1]=5",
                            "X 5",
                            "X--5",
                            "X1.2.3",
                            "X=1 X2",
                            "G1 G0 X5",
                            "G54 G55",
                            "MCALL L10",
                            "AP=45 RP=10",
                            "GEOAX(1,X)",
                            "STOPREX",
                            "X5 RND=2",
                            "X5 CHF=2",
                            "X5 Y5 CHR=1",
                            "ANG=45 X5",
                            "DIAMON",
                            "OFFN=5",
                            "TRANSMIT",
                            "TRACYL(40)",
                            "G291",
                            "M98 P10",
                            "SETAL(65000)",
                            "D=R1",
                            "X1O",
                            "X10,5",
                            "Z-",
                            "G17 G18",
                            "G90 G91",
                            "G60 G64",
                            "TRANS X1 ROT Z1",
                            "D1 D0",
                            "T=R1",
                            "CUT3DC",
                            "WALIMON",
                            "MSG(\"A",
                            "AROT",
                            "N20 N30 G1 X5",
                            "TRAORI(2)",
                            "M1=6",
                            "G1 X5 TRAORI"}) {
    const ReadOutcome outcome = test::read_siemens(kHead + std::string(block) + "\nG1 X1 F100\nM30\n");
    EXPECT_FALSE(test::can_be_clean(outcome)) << block;
    ASSERT_TRUE(outcome.toolpath.has_value()) << block;
    EXPECT_FALSE(outcome.toolpath->moves.back().not_checked_reason.empty()) << block;
    EXPECT_NE(test::reasons_of(outcome).find("line 5"), std::string::npos) << block << test::reasons_of(outcome);
  }
}

TEST(SiemensTraps, StatesThatNothingStates) {
  const auto reasons = [](const std::string& text) { return test::reasons_of(test::read_siemens(text)); };
  EXPECT_NE(reasons("G17 G71 G90 G60\nT1 M6\nG0 X0 Y0 Z5 D1\nG1 X1 F100\nM30\n").find("--start G54"),
            std::string::npos);
  EXPECT_NE(reasons("G17 G71 G90 G60 G54\nT1 M6\nG0 X0 Y0 Z5\nG1 X1 F100\nM30\n").find("nothing states D"),
            std::string::npos);
  EXPECT_NE(reasons("G17 G71 G60 G54\nT1 M6\nG0 X0 Y0 Z5 D1\nG1 X1 F100\nM30\n").find("--start G90"),
            std::string::npos);
  EXPECT_NE(reasons("G17 G71 G90 G54\nT1 M6\nG0 X0 Y0 Z5 D1\nG1 X1 F100\nM30\n").find("--tip-tolerance"),
            std::string::npos);
  EXPECT_NE(reasons("G71 G90 G60 G54\nT1 M6\nG0 X0 Y0 Z5 D1\nG2 X1 Y1 I1 J0 F100\nM30\n").find("--start G17"),
            std::string::npos);
}

TEST(SiemensTraps, SmoothingWithoutItsTolerance) {
  expect_open("G64\nG1 X5 F100", "an unknown distance");
  expect_open("G642\nG1 X5 F100", "an unknown distance");
  expect_open("CYCLE832(0.02,1,1)\nG1 X5 F100", "0.0693 mm");
  for (const char* call : {"CYCLE832(0.02)", "CYCLE832(0.02,0,1)", "CYCLE832(0.02,10,1)", "CYCLE832(0.02,X,1)"})
    expect_open(std::string(call) + "\nG1 X5 F100", "an unknown distance");
  expect_open("CYCLE832()\nG1 X5 F100", "an unknown distance");
  expect_open("COMPCAD\nG1 X5 F100", "--tip-tolerance");
  ProgramSetup setup;
  setup.tip_tolerance_mm = 0.01;
  expect_open("CYCLE832(0.02,1,1)\nG1 X5 F100", "0.0693 mm", setup);
  expect_open("CTOL=0.01\nG642\nG1 X5 F100", "0.0173 mm", setup);
  expect_open("G641 ADIS=0.01 ADISPOS=0.5\nG1 X5 F100", "0.5 mm", setup);
}

TEST(SiemensTraps, SmoothingOfTheToolAxis) {
  const std::string blocks = "G0 B0 C0\nTRAORI\nCYCLE832(0.02,1,0.5)\nG0 X1 Y2 Z50\nG1 C10 F100";
  ProgramSetup setup = full_setup();
  setup.tip_tolerance_mm = 0.07;
  expect_open(blocks, "0.5 degrees; expected --axis-tolerance", setup);
  setup.axis_tolerance_rad = 0.01;
  EXPECT_TRUE(test::can_be_clean(test::read_siemens(kHead + blocks + "\nM30\n", setup)));
}

TEST(SiemensTraps, CompensationIsNotChecked) { expect_open("G41 G1 X5 F100\nX6\nG40 X7", "compensated by the radius"); }

TEST(SiemensTraps, LengthsOfOtherEdgesAndNoTool) {
  expect_open("G1 Z5 F100 D2", "D2 selects a cutting edge");
  expect_open("G1 Z5 F100 D2\nD1\nX5\nX6\nX7", "9: the place of the tool is not known");
  expect_open("G18\nG1 Z5 F100", "G18 or G19");
  expect_open("G18\nG1 Z5 F100\nG17\nX5\nX6\nX7", "10: the place of the tool is not known");
  expect_open("G1 Z5 F100 D0", "length");
  expect_open("T0 M6\nG1 X5 F100 D1", "holds no tool");
  expect_open("T=\"OTHER\" M6\nG0 X5 Y5 Z5", "nothing states D after the change");
}

TEST(SiemensTraps, StepsAfterAChangeOfFrame) {
  expect_open("TRANS X5\nG91 G1 X1 F100", "after a change of frame or length");
  expect_open("G91 G1 Z1 D1 F100", "after a change of frame or length");
}

TEST(SiemensTraps, ValuesOfTheControl) {
  expect_open("R1=$AA_IM[X]\nG1 X=R1 F100", "is not known");
  expect_open("G1 X=R77 F100", "is not known");
  expect_open("IF R77>1 GOTOF A\nA: G1 X1 F100", "condition whose value is not known");
  expect_open("R1=1 R2=R1\nG1 X=R2 F100", "is not known");
  expect_open("R2=2\nIF R1==1 AND R2==2\nG1 X1 F100\nENDIF", "is not known");
  expect_open("TRANS X=$AA_IW[X]\nG1 X1 F100", "a value of TRANS is not known");
}

TEST(SiemensTraps, RapidsWhoseAxesRunApart) {
  expect_open("RTLIOF\nG0 X5 Y5", "law independent");
  ProgramSetup setup = full_setup();
  expect_open("RTLIOF\nG0 X5 Y5", "law independent", setup);
  setup.are_joint_rapids_straight = false;
  expect_open("RTLION\nG0 X5 Y5", "law joint", setup);
}

TEST(SiemensTraps, ModalCyclesRunAfterEveryMotion) {
  const std::string start = "G1 Z20 F100\nMCALL CYCLE81(10,0,3,-6)\n";
  expect_open(start + "G53 X5", "begins below its safe level, or at an unknown one");
  expect_open("G0 B0 C0\n" + start + "G0 C10", "rotary axes alone move", full_setup());
}

TEST(SiemensTraps, OffsetsOfRotaryAxesUnderTraori) {
  ProgramSetup setup = full_setup();
  setup.offsets["G54"].abc_deg = Vec3(0, 0, 10);
  expect_open("G0 B0 C0\nTRAORI\nG0 X1 Y2 Z50", "work offset of rotary axes", setup);
}

TEST(SiemensTraps, BlocksThatASwitchLeavesOut) {
  expect_open("/G1 Z-5 F100", "--block-delete");
  ProgramSetup setup;
  setup.is_block_delete_on = true;
  EXPECT_TRUE(test::can_be_clean(test::read_siemens(kHead + "/G1 Z-5 F100\nM30\n", setup)));
}

TEST(SiemensTraps, FixedPointsAndPlacesOfTheMachine) {
  expect_open("G74 X1=0 Z1=0\nG0 X1 Y1 Z1", "only the control knows");
  expect_open("G75 Z1=0", "only the control knows");
  expect_open("G53 G0 Z5", "expected SUPA or G153");
  expect_open("SUPA G0 X5", "--offset");
  expect_open("SUPA G0 Z5", "expected D0");
  expect_open("SUPA G91 G0 X5", "absolute values");
  ProgramSetup setup;
  setup.offsets["G54"] = WorkOffset{};
  expect_open("TRAORI\nG0 X1 Y1 Z1 A3=0 C3=1\nSUPA G0 X5", "while TRAORI is in force", setup);
}

TEST(SiemensTraps, RotaryAxesNeedTheirMachine) {
  const ReadOutcome outcome = test::read_siemens(kHead + "G0 B10\nM30\n");
  ASSERT_FALSE(outcome.errors.empty());
  EXPECT_EQ(outcome.errors[0].code, "gcode-machine");
}

TEST(SiemensTraps, TheWayOfARotaryAxis) {
  const std::string head = "G0 B0 C0\nTRAORI\nG0 X1 Y2 Z50\n";
  expect_open(head + "G1 C-10 F100", "--rotary-turns", full_setup());
  expect_open(head + "G1 C270 F100", "--rotary-turns", full_setup());
  expect_open(head + "G1 C=DC(180) F100", "half a turn", full_setup());
  // No manual states whether an axis of one turn counts the turn that DC completes.
  ProgramSetup winds = full_setup();
  winds.winds_as_programmed = true;
  expect_open(head + "G1 C350 F100\nC=DC(10)\nC20", "beyond a turn by DC", winds);
  expect_open(head + "G1 C=IC(350) F100\nC=ACP(10)\nC0", "beyond a turn by DC", winds);
  for (const char* way : {"G1 C20 F100\nC=DC(10)\nC20", "G1 C350 F100\nC=DC(10)\nC=DC(20)"})
    EXPECT_TRUE(test::can_be_clean(test::read_siemens(kHead + head + way + "\nM30\n", winds))) << way;
}

// The great circle leaves the box of the rotary joints, which the law any covers.
TEST(SiemensTraps, TheLawAnyDoesNotCoverVectors) {
  ProgramSetup setup = full_setup();
  setup.laws = TurnLaws{TurnLaw::any, TurnLaw::any, TurnLaw::joint};
  const std::string start = "G0 B0 C0\nTRAORI\nG0 X1 Y2 Z50\n";
  expect_open(start + "ORIVECT\nG1 X5 B30 F100", "expected --feed-law documented", setup);
  EXPECT_TRUE(test::can_be_clean(test::read_siemens(kHead + start + "ORIAXES\nG1 X5 B30 F100\nM30\n", setup)));
}

// Rounding rounds the turns of rotary axes too, with TRAORI and without it.
TEST(SiemensTraps, RoundingNeedsAToleranceOfTheAxis) {
  ProgramSetup setup = full_setup();
  setup.tip_tolerance_mm = 0.1;
  setup.winds_as_programmed = true;
  const std::string start = "G0 B0 C0\nG0 X1 Y2 Z50\nG64\nG1 X3 F100\n";
  expect_open(start + "X5 B30", "G64 in line", setup);
  EXPECT_TRUE(test::can_be_clean(test::read_siemens(kHead + start + "X5\nM30\n", setup)));
  expect_open("G0 B0 C0\nTRAORI\nG0 X1 Y2 Z50\nG60 COMPCAD CTOL=0.01\nG1 X3 F100", "COMPCAD in line", setup);
}

TEST(SiemensTraps, LawsOfTheProgramAndOfTheCheck) {
  const std::string blocks = "G0 B0 C0\nTRAORI\nORIMKS\nG0 X1 Y2 Z50\nG1 C10 F100";
  expect_open(blocks, "ORIMKS turns the tool by law axis", full_setup());
  ProgramSetup setup = full_setup();
  setup.laws = TurnLaws{TurnLaw::documented, TurnLaw::documented, std::nullopt};
  const ReadOutcome outcome = test::read_siemens(kHead + blocks + "\nM30\n", setup);
  EXPECT_EQ(test::reasons_of(outcome).find("ORIMKS"), std::string::npos);
  setup.laws = TurnLaws{TurnLaw::axis, TurnLaw::axis, std::nullopt};
  expect_open("G0 B0 C0\nTRAORI\nORIWKS ORIAXES\nG0 X1 Y2 Z50", "ORIWKS turns the tool by law vector", setup);
}

TEST(SiemensTraps, VectorsNeedTraoriAndTheWorkpiece) {
  expect_open("G1 X5 A3=1 F100", "without TRAORI");
  expect_open("TRAORI\nORIMKS\nG1 X5 A3=1 F100", "ORIMKS");
  expect_open("TRAORI\nG1 X5 A3=0 F100", "direction of the tool");
  expect_open("TRAORI\nSCALE X2\nG1 X5 A3=1 F100", "direction of the tool");
}

TEST(SiemensTraps, FramesWhoseFateIsNotStated) {
  expect_open("TRANS X5\nTRAORI\nG0 X1 Y1 Z1", "TRAORI stands while a frame", full_setup());
  expect_open("TRANS X5\nCYCLE800()\nG0 X1 Y1 Z1", "CYCLE800 may end the frame", full_setup());
  expect_open("CYCLE800(0,\"TC\",0,192,0,0,0,0,90,0,0,0,0,1)\nG0 X1 Y1 Z1", "this form of CYCLE800", full_setup());
  expect_open("G0 B0 C0\nCYCLE800(0,\"TC\",0,57,0,0,0,0,90,0,0,0,0,0)\nG0 X1 Y1 Z1", "not aligned", full_setup());
  for (const char* const state : {"1", "100", "200001", "200100", "1000", "210000", "300000", "0.5", "-1"}) {
    const std::string call = std::string("CYCLE800(0,\"TC\",") + state + ",57,0,0,0,0,90,0,0,0,0,1)";
    expect_open(call + "\nG0 X1 Y1 Z1", "this form of CYCLE800", full_setup());
  }
  expect_open("CYCLE800(0,\"TC\",0,57,0,0,0,0,90,0,0,0,0,1,0,2)\nG0 X1 Y1 Z1", "this form of CYCLE800", full_setup());
  expect_open("G18 D0\nCYCLE800(0,\"TC\",0,57,0,0,0,0,90,0,0,0,0,1)\nG0 X1 Y1 Z1", "plane of G17", full_setup());
  expect_open("TRANS A5\nG0 X1", "TRANS");
  expect_open("TRANS X5 G1\nG0 X1", "TRANS");
  expect_open("SCALE X0\nG0 X1", "a value of SCALE");
  expect_open("SCALE X2\nAROT Z45\nG0 X1 Y1 Z1", "turns a frame with different scales");
}

TEST(SiemensTraps, TheToolStaysTiltedWithoutAMachine) {
  expect_open("TRAORI\nG1 X5 F100", "TRAORI without a direction");
  expect_open("TRAORI\nG1 X5 Y0 Z0 A3=1 C3=1 F100\nTRAFOOF\nG0 X1 Y1 Z1\nX2", "stays tilted after TRAFOOF");
}

TEST(SiemensTraps, TextsThatNameM6DoNotChangeTheTool) {
  const Toolpath path =
      test::path_of_siemens("G17 G71 G90 G94 G60 G54\nMSG(\"USE M6\")\nT1 D1\nG0 X0 Y0 Z9\nT2 D1\nG0 X1 Y0 Z9\nM30\n");
  EXPECT_EQ(path.tools.size(), 2U);
}

TEST(SiemensTraps, G500BeforeTheOffsetOfThePart) {
  const ReadOutcome outcome =
      test::read_siemens("G17 G71 G90 G94 G60 G500\nT1 M6\nG0 X0 Y0 Z9 D1\nG54\nG0 X1 Y1 Z1\nG1 X2 F1\nM30\n");
  ASSERT_TRUE(outcome.toolpath.has_value());
  EXPECT_FALSE(outcome.toolpath->moves[0].not_checked_reason.empty());
  test::expect_at(outcome.toolpath->moves.back().end.tip, 2, 1, 1);
}

TEST(SiemensTraps, TheEndOfAProgramInASubprogram) {
  ProgramSetup setup;
  setup.read_beside = [](const std::string&) { return std::vector<std::string>{"G1 X5 F100\nM30\n"}; };
  expect_open("L5\nG1 X1 F100", "in a subprogram", setup);
  expect_open("R2=3\nFOR R1=1 TO R2\nR2=5\nENDFOR\nG1 X1 F100", "a limit of FOR changes");
}

TEST(SiemensTraps, AUnitBehindPositions) {
  const ReadOutcome outcome =
      test::read_siemens("G17 G90 G94 G60 G54\nT1 M6\nG0 X0 Y0 Z9 D1\nG1 X1 F100\nG710\nX2\nM30\n");
  EXPECT_FALSE(test::can_be_clean(outcome));
  EXPECT_NE(test::reasons_of(outcome).find("G710 states the unit"), std::string::npos) << test::reasons_of(outcome);
}

TEST(SiemensTraps, ADwellKeepsTheCodeOfMotion) {
  const Toolpath path = test::path_of_siemens(kHead + "G1 G4 F2\nX5\nM30\n");
  EXPECT_EQ(path.moves.back().kind, MoveKind::feed);
}

TEST(SiemensTraps, TipControlThatNothingStates) {
  ProgramSetup setup = full_setup();
  const ReadOutcome outcome = test::read_siemens(
      "G17 G71 G90 G94 G60 G54\nT1 M6\nG0 B0 C0\nG0 X0 Y0 Z500 D1\nG0 B90\nG1 X1 F100\nM30\n", setup);
  EXPECT_NE(test::reasons_of(outcome).find("tool centre point control"), std::string::npos);
}

TEST(SiemensTraps, CyclesThatAreNotUnderstood) {
  expect_open("CYCLE86(10,0,3,-6,,1,3,1,1,1,0)", "moves across the hole");
  expect_open("CYCLE81(10,0,3,-6,5)", "states its depth twice");
  expect_open("CYCLE81(10,0,3,6)", "not in their order");
  expect_open("CYCLE81(10,0,3,R9)", "depth of CYCLE81 is not known");
  expect_open("CYCLE81(10,,3,-6)", "a level of CYCLE81 is not known");
  expect_open("CYCLE82(10,0,3,-6,,0,0,2,12)", "an argument of CYCLE82 is not read");
  expect_open("G18\nCYCLE81(10,0,3,-6)", "G18");
  expect_open("G1 Z1 F100\nCYCLE81(10,0,3,-6)", "begins below its safe level");
}

TEST(SiemensTraps, ArcsThatAreNotUnderstood) {
  expect_open("G2 X5 Y5 F100", "");
  expect_open("G2 X5 Y5 I1 J1 CR=5 F100", "");
  expect_open("G2 X5 Y5 I=AC(1) J1 F100", "absolute in one word");
  expect_open("CIP X5 Y5 I1=2.5 J1=2.5 F100", "on a line");
  expect_open("G1 X5 I5 F100", "words of an arc");
  expect_open("G2 I5 AR=360 F100", "opening angle");
  expect_open("G2 X5 Y5 I5 J0 TURN=R9 F100", "");
}

TEST(SiemensTraps, ProgramsWithoutTheirEnd) {
  EXPECT_FALSE(test::can_be_clean(test::read_siemens(kHead + "G1 X5 F100\n")));
  EXPECT_FALSE(test::can_be_clean(test::read_siemens("G0 X5\n%_N_A_MPF\n" + kHead + "G1 X5 F100\nM30\n")));
  EXPECT_TRUE(test::can_be_clean(test::read_siemens("%_N_A_MPF\n;$PATH=/_N_MPF_DIR\n" + kHead + "G1 X5 F100\nM30\n")));
}

}  // namespace
}  // namespace gouge::siemens_traps_test
