#include <gtest/gtest.h>

#include "tests/postproc/gcode/heidenhain/klartext.h"

// Programs that a careless reader would take for clean: none is wholly checked.

namespace gouge::klartext::klartext_traps_test {
namespace {

const std::string kStart = "L X+0 Y+0 Z+10 R0 FMAX\n";

void expect_none_clean(const std::vector<std::string>& programs, const GcodeOptions& options = {}) {
  for (const std::string& blocks : programs) {
    const ReadOutcome outcome = outcome_of(with_ends(blocks), options);
    const bool is_clean =
        outcome.toolpath && outcome.toolpath->words_not_understood.empty() && count_open(*outcome.toolpath) == 0;
    EXPECT_FALSE(is_clean) << blocks;
  }
}

std::string drilling(const std::string& parameters) { return "CYCL DEF 200 D " + parameters + "\n" + kStart; }
constexpr const char* kDepths = "Q200=2 Q201=-5 Q203=0 Q204=9";

// Trap 2: facts that are missing.
TEST(KlartextTraps, PlacesThatNothingStates) {
  expect_none_clean({kStart + "L X+5 FMAX M92\n", kStart + "L X+5 FMAX M91\n", kStart + "L X+5 M130\n",
                     kStart + "L M140 MB50\nL X+5 FMAX\n", kStart + "L M6\nL X+5 F100\n",
                     "CYCL DEF 247 D Q339=1\n" + kStart + "CYCL DEF 247 D Q339=2\n" + kStart,
                     "CYCL DEF 7.0 X\nCYCL DEF 7.1 #1\n" + kStart});
}

// Trap 3: words, functions, macros and cycles without a row.
TEST(KlartextTraps, WordsWithoutARow) {
  expect_none_clean({"SEL TABLE \"A.D\"\n" + kStart, "PATTERN DEF POS1 (X+1 Y+2 Z+0)\n" + kStart,
                     kStart + "CALL PGM SUB.H\nL X+5 F100\n",
                     "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 SUB.H\n" + kStart + "L X+5 M99 F100\n",
                     "FUNCTION MODE TURN\n" + kStart, "TRANS DATUM AXIS X+10\n" + kStart,
                     "CYCL DEF 20.0 CONTOUR DATA Q1=-5\n" + kStart, kStart + "FL X+5\n", kStart + "SPL X+5 K3X+1\n",
                     kStart + "X+20 R+ F100\n", kStart + "APPR LT X+1 Y+2 LEN5 RL F100\nDEP LT LEN5\n",
                     kStart + "GOTO LBL 5\nLBL 5\nL X+5 F100\n", kStart + "IF Q1 = 5 THEN\nL X+5 F100\nENDIF\n",
                     kStart + "L U+5 F100\n", kStart + "L M144\nL X+5 F100\n", kStart + "L M101\nL X+5 F100\n",
                     kStart + "L M94\nL X+5 F100\n", kStart + "END PGM A MM\nBEGIN PGM B MM\nL X+5\n",
                     "BEGIN PGM B INCH\n" + kStart});
}

// Statements without an effect have the words of their forms alone, in one line.
TEST(KlartextTraps, WordsBehindStatementsWithoutAnEffect) {
  for (const char* statement :
       {"BLK FORM 0.1 Z X+0 Y+0 Z-20", "BLK FORM 0.2 X+9 Y+9 IZ+20", "BLK FORM CYLINDER Z R50 L105 DIST+5 RI10",
        "BLK FORM ROTATION Z DIM_R LBL 1", "BLK FORM FILE \"A.STL\" TARGET \"B.STL\"", "FN 14: ERROR = 1000",
        "FN 15: PRINT Q1/20", "FN 16: F-PRINT TNC:\\A.A / \"B C.TXT\"", "FN 18: SYSREAD Q1 = ID210 NR4 IDX3",
        "FN 20: WAIT FOR SYNC", "FN 20: WAIT FOR I32==+1", "FN 38: SEND /\"Q1: %F\" / +Q1", "FN 13: Q1 = +5 ANG +Q2",
        "FN 8: Q1 = +5 LEN +3", "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 V.ZEIT 0.5",
        "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 5", "CYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE+90"}) {
    const std::string text = statement, end = "\nL X+1 F100\nL M30\nLBL 1\nL X+2\nLBL 0\n";
    EXPECT_EQ(count_open(blocks_of(kStart + text + end)), 0U) << text;
    for (const char* words :
         {" L X+50", " X+50 R0", " M6", " ~\nL X+50", " ~\nX+50 R0", " ~\nCYCL CALL", " JUNK", " FMAX"})
      expect_none_clean({kStart + text + words + end});
  }
  expect_none_clean({kStart + "BLK FORM 0.1 Z X+0 Y+0 ~\nZ-20\nL X+1\n", kStart + "BLK FORM 0.1 Z X+0 X+50\nL X+1\n",
                     kStart + "BLK FORM 0.1 Z X+0 IX+50\nL X+1\n", kStart + "BLK FORM 0.3 X+0\nL X+1\n",
                     kStart + "BLK FORM\nBLK FORM X+5\nL X+1\n", kStart + "FN 14 L X+5\nL X+1\n"});
}

// The first step of an axis may begin at the place of the tool, or at its coordinate before the shift.
TEST(KlartextTraps, StepsAfterAChangeOfTheFrame) {
  const std::string shift = "CYCL DEF 7.0 X\nCYCL DEF 7.1 X+10\n";
  expect_none_clean({kStart + shift + "L IX+10 F100\n", kStart + shift + "L Y+5 IX+10 F100\n",
                     kStart + shift + "CC IX+10 Y+0\nC X+0 Y+0 DR+ F100\n", kStart + shift + "CC\nLP PR+5 PA+0 F100\n",
                     "L X+5 Y+0 Z+10 R0 FMAX\nCYCL DEF 8.0 M\nCYCL DEF 8.1 X\nL IX+10 F100\n",
                     kStart + shift + "L Y+5 F100\nL IX+1\n", kStart + shift + "CR IX+10 Y+0 R+9 DR+ F100\n",
                     "CYCL DEF 247 D Q339=1\n" + kStart + shift + "LBL 1\nL IX+1\nCALL LBL 1 REP 2\n"});
  EXPECT_EQ(tips(blocks_of(kStart + shift + "L X+0 F100\nL IX+1\n")), "(0,0,10) (10,0,10) (11,0,10)");
  EXPECT_EQ(tips(blocks_of(kStart + shift + "L IY+3 IZ+1 F100\n")), "(0,0,10) (0,3,11)");
  EXPECT_EQ(tips(blocks_of(kStart + "CYCL DEF 7.0 X\nCYCL DEF 7.1 X+0\nL IX+3 F100\n")), "(0,0,10) (3,0,10)");
}

// Trap 7: frames in an order, or in a form, whose meaning no manual at hand states.
TEST(KlartextTraps, FramesThatAreNotKnown) {
  expect_none_clean(
      {"CYCL DEF 7.0 X\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+3\n" + kStart + "CYCL DEF 7.0 X\nCYCL DEF 7.1 X+0\n" + kStart,
       "CYCL DEF 10.0 R\nCYCL DEF 10.1 ROT+90\nCYCL DEF 7.0 X\nCYCL DEF 7.1 X+10\n" + kStart,
       "CYCL DEF 8.0 M\nCYCL DEF 8.1 Z\n" + kStart, "CYCL DEF 26.0 S\nCYCL DEF 26.1 X2 Y2\n" + kStart,
       "CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL 0.5\n" + kStart, "PLANE RELATIV SPB+45 TURN FMAX\n" + kStart,
       "PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY\n" + kStart + "L X+5 F100\n",
       "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\n" + kStart + "PLANE RESET STAY\n" + kStart + "L X+5 F100\n",
       "CYCL DEF 19.0 W\nCYCL DEF 19.1 A+0 B+45 C+0\n" + kStart});
}

// Trap 8: compensation by the control.
TEST(KlartextTraps, Compensation) {
  expect_none_clean({kStart + "L X+5 RL F100\nL Y+5\nL X+0 R0\n", kStart + "LN X+1 Y+1 Z+1 NX0 NY0 NZ1\n",
                     "TOOL CALL 2 Z S1 DL+Q1\n" + kStart + "L X+5 F100\n",
                     "TOOL CALL 2 Z S1 DL-0.3\n" + kStart + "L X+5 F100\n", "TOOL CALL 2 Y S1\n" + kStart});
}

// Trap 9: paths that the control smooths or changes.
TEST(KlartextTraps, OtherPaths) {
  expect_none_clean({"CYCL DEF 32.0 T\nCYCL DEF 32.1 T0.1\n" + kStart + "L X+5 F100\n",
                     kStart + "L X+5 F100\nRND R1\nL Y+5\n", kStart + "L X+5 F100\n; a comment\nCHF 1\nL Y+5\n",
                     kStart + "L M118 X1 Y1\nL X+5 F100\n", kStart + "L X+5 F100 M90\nL Y+5\n"});
}

// Trap 10: blocks and values that the control decides on.
TEST(KlartextTraps, ValuesOfTheControl) {
  expect_none_clean({kStart + "/ L X+5 F100\nL X+6\n", "TCH PROBE 0.0 REF PLANE Q5 Z-\nTCH PROBE 0.1 X+5\n" + kStart,
                     kStart + "L X+Q150 F100\n", kStart + "FN 18: SYSREAD Q1 = ID270 NR1 IDX1\nL X+Q1 F1\n",
                     kStart + "CALL LBL Q1\n", kStart + "L X+Q9 F100\n"});
}

TEST(KlartextTraps, Arcs) {
  expect_none_clean({kStart + "CC X+5 Y+0\nC X+10 Y+0 Z-5 DR+ F100\n", kStart + "CC X+5 Y+0\nC X+10 Y+0 F100\n",
                     kStart + "CC X+5 Y+0\nC X+10.3 Y+0 DR+ F100\n", kStart + "CT X+5 Y+5 F100\n",
                     kStart + "CR X+10 Y+0 R+2 DR+ F100\n", kStart + "CC X+5 Y+0\nCP IPA-90 DR+ F100\n",
                     kStart + "CC X+5\nC X+10 Y+0 DR+ F100\n"});
}

TEST(KlartextTraps, Cycles) {
  expect_none_clean({drilling(kDepths) + "L X+5 M89\nL X+6\n", drilling(kDepths) + "CYCL CALL POS X+5 Y+5 Z-3 FMAX\n",
                     drilling("Q200=2 Q201=0 Q203=0 Q204=9") + "CYCL CALL\n",
                     drilling(std::string(kDepths) + " Q395=1") + "CYCL CALL\n",
                     "CYCL DEF 240 D Q200=2 Q201=-5 Q203=0 Q204=9 Q343=1\n" + kStart + "CYCL CALL\n"});
}

// Trap 11: numbers that are none.
TEST(KlartextTraps, Numbers) {
  expect_none_clean(
      {kStart + "L X+1,5 F100\n", kStart + "L X+1E2 F100\n", kStart + "L X+-5 F100\n", kStart + "L X+5.5.5 F100\n"});
}

// Trap 16: calls and loops.
TEST(KlartextTraps, Flow) {
  expect_none_clean({kStart + "CALL LBL \"A\"\n", kStart + "LBL 1\nFN 9: IF +1 EQU +1 GOTO LBL 1\nL X+5\n",
                     kStart + "LBL 1\nLBL 1\nCALL LBL 1\n"});
}

// Traps 14, 15 and 17: rotary axes and tool centre point control without what they need.
TEST(KlartextTraps, RotaryAxes) {
  expect_none_clean({kStart + "L X+5 M128 F100\n", kStart + "L C+90 FMAX\n", kStart + "REFPNT TIP-TIP\nL X+5\n"});
  const std::string home = "L B+0 C+0 FMAX\n" + kStart;
  expect_none_clean({home + "L X+5 B+5 M128 F100\n", kStart + "L X+5 F100\n", home + "M128\nL C+90 F100\nL C+280\n",
                     home + "FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nL B+5 F100\n",
                     home + "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL B+5 F100\n"},
                    on_machine("table-b-head"));
}

}  // namespace
}  // namespace gouge::klartext::klartext_traps_test
