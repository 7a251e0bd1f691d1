#include "postproc/cldata/parsing/machine_text.h"

#include <gtest/gtest.h>

#include <string>

#include "postproc/cldata/parsing/cutter_statement.h"

namespace gouge::machine_text_test {
namespace {

/// The effects of a text as letters: moves, shifts, length, cycle, steps, tool, offset, end, unknown.
std::string effects(std::string_view text) {
  const MachineEffect e = read_machine_text(text);
  std::string letters;
  if (e.is_unknown) return "?";
  if (e.moves) letters += 'm';
  if (e.shifts) letters += 's';
  if (e.changes_length) letters += 'l';
  if (e.begins_cycle) letters += 'c';
  if (e.begins_steps) letters += 'i';
  if (e.changes_tool) letters += 't';
  if (!e.work_offset.empty()) letters += 'o';
  if (e.ends_program) letters += 'e';
  return letters;
}

TEST(MachineText, ReportsWhatGCodeDoes) {
  EXPECT_EQ(effects("G0 X1 Y2"), "m");
  EXPECT_EQ(effects("g00z-1"), "m");
  EXPECT_EQ(effects("N10 G90 G54 G0 X0"), "mo");
  EXPECT_EQ(effects("G1 F100"), "");
  EXPECT_EQ(effects("G3 I5."), "m");
  EXPECT_EQ(effects("G92 X0"), "s");
  EXPECT_EQ(effects("G92 S2000"), "");
  EXPECT_EQ(effects("G68.2 X0 Y0 Z0 I0 J30. K0"), "s");
  EXPECT_EQ(effects("G91 G28 Z0 G90"), "m");
  EXPECT_EQ(effects("G91 G28 Z0"), "mi");
  EXPECT_EQ(effects("G81 Z-5. R2. F100"), "mc") << "it drills here, too";
  EXPECT_EQ(effects("G43 H2"), "l");
  EXPECT_EQ(effects("G43.4 H2"), "l");
  EXPECT_EQ(effects("T5 M6"), "t");
  EXPECT_EQ(effects("G0 A90."), "ms");
  EXPECT_EQ(effects("G0 A0."), "m");
  EXPECT_EQ(effects("M30"), "e");
}

TEST(MachineText, ReportsTheDistanceByWhichTheControlMayLeaveThePath) {
  const auto distance = [](const char* text) { return read_machine_text(text).smoothing; };
  EXPECT_EQ(distance("G187 P1 E0.5"), 0.5);
  EXPECT_NEAR(distance("CYCLE832(0.25,3)").value_or(0), 0.5 * std::sqrt(3), 1e-12) << "0.25 for each axis, twice";
  EXPECT_EQ(distance("G64 P0.1"), 0.1);
  EXPECT_EQ(distance("G64 P0.1 Q0.2"), 0.2);
  EXPECT_EQ(distance("CYCL DEF 32.1 T0.03"), 0.03);
  EXPECT_EQ(distance("COMPCAD"), std::nullopt);
}

TEST(MachineText, ReportsThatRotaryJointsRunInProportion) {
  for (const char* const text : {"ORIAXES", "oriaxes", "ORIMKS", "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS"})
    EXPECT_TRUE(read_machine_text(text).turns_axes) << text;
  for (const char* const text : {"ORIVECT", "ORIWKS", "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR", "TRAORI", "M128"})
    EXPECT_FALSE(read_machine_text(text).turns_axes) << text;
}

TEST(MachineText, ReportsThatTheSpindleStopsOrStarts) {
  for (const char* const stop : {"M5", "M05 M09", "M19 R90", "M3 M5", "L Z+50 R0 FMAX M5", "SPOS=90"})
    EXPECT_EQ(read_machine_text(stop).stops_spindle, true) << stop;
  for (const char* const start : {"M3", "M03 S900", "M4", "M13", "M14"})
    EXPECT_EQ(read_machine_text(start).stops_spindle, false) << start;
  for (const char* const other : {"M8", "G5", "S900", ""})
    EXPECT_EQ(read_machine_text(other).stops_spindle, std::nullopt) << other;
}

TEST(MachineText, TakesABlockForHarmlessWhereEveryWordIsInTheList) {
  for (const char* text : {"M8", "N5 G17 G40 G80 G90", "M03 S12000", "G4 X2.5", "G04 P1000", "G5.1 Q1", "G05 P10000",
                           "G187 P1 E0.01", "G64 P0.01", "G96 S200", "M19 R90", "M41", "%", "O1234", "G642", ""})
    EXPECT_EQ(effects(text), "") << text;
}

TEST(MachineText, TakesNoBlockForHarmlessWithAWordThatIsNotInTheList) {
  for (const char* text : {"G777",
                           "G1.5",
                           "G6.2",
                           "G11",
                           "M98 P1000",
                           "M200",
                           "M50",
                           "G65 P9810 Z-50.",
                           "#100=-12",
                           "L1234 P3",
                           "MYPROG P2",
                           "G1 AP=30 RP=20",
                           "AP=30 RP=20",
                           "COPY X10 Y0 Q3 P30",
                           "ED30",
                           "EC30",
                           "VZOFZ=-12",
                           "GOTO 100",
                           "IF[#1EQ0]GOTO10",
                           "IF Q1 EQU 0 GOTO LBL 1",
                           "G1 Z[-50]",
                           "M8 G777",
                           "G4 X2 W5 M99",
                           "TRAILER",
                           "G5 P10000 L2"})
    EXPECT_EQ(effects(text), "?") << text;
}

TEST(MachineText, ReportsWhatSiemensWordsDo) {
  for (const char* text : {"CYCLE832(0.01,1,1)", "CYCLE832(0.01) M8", "SPOS=0", "TRAORI", "TRAORI(1)", "STOPRE", "SOFT",
                           "MSG(\"DRILL (X)\")", "N20 ORIWKS", "WORKPIECE(,,,\"BOX\",112,0,-20,-80,0,0,100,60)"})
    EXPECT_EQ(effects(text), "") << text;
  for (const char* text : {"ATRANS Z-50", "TRANS", "TRAFOOF", "CYCLE800(1)", "POCKET3(50,0,2)", "MYSUB(1,2)",
                           "MIRROR X0", "MSG(\"X\") TRANS X1", "STOPRE X", "SUPA Z0", "CALL BLOCK A TO B"})
    EXPECT_EQ(effects(text), "?") << text;
  EXPECT_EQ(effects("MSG(\"X\") G91"), "i");
  EXPECT_EQ(effects("TRAORI Z-10"), "m");
  EXPECT_EQ(effects("MCALL CYCLE81(10,0,1,-50)"), "c");
  EXPECT_TRUE(read_machine_text("MCALL").ends_cycle);
}

TEST(MachineText, ReportsWhatHeidenhainWordsDo) {
  EXPECT_EQ(effects("L X+10 R0 FMAX M3"), "m");
  EXPECT_EQ(effects("12 L IZ-50 R0 F MAX"), "m");
  EXPECT_EQ(effects("CYCL DEF 247 DATUM SETTING ~ Q339=+1"), "o");
  for (const char* text : {"L M5", "TOOL CALL S3000", "TOOL DEF 5", "CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T0.05",
                           "CYCL DEF 32.2 HSC-MODE:1 TA0.5", "CYCL DEF 9.1 V.ZEIT 2", "STOP M8", "LBL 1",
                           "BLK FORM 0.1 Z X+0 Y+0 Z-20", "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS", "M128"})
    EXPECT_EQ(effects(text), "") << text;
  for (const char* text : {"CYCL DEF 7.0",
                           "CYCL DEF 7.0 DATUM SHIFT",
                           "CYCL DEF 200 Q200=2",
                           "CYCL DEF 5000000000",
                           "CYCL CALL M3",
                           "TOOL CALL 5 Z S2000",
                           "TOOL DEF 5 L+12",
                           "TRANS MIRROR AXIS X",
                           "TRANS ROTATION ROT+30",
                           "PRESET CORR Z-12",
                           "FUNCTION CORRDATA TCS #1",
                           "FUNCTION MODE TURN",
                           "FUNCTION RESET TCPM",
                           "M140 MB MAX",
                           "L X+10 RL",
                           "TCH PROBE 410 DATUM",
                           "POLARKIN AXES X Z C MODE:KEEP",
                           "FN 9: IF +Q1 EQU +0 GOTO LBL 1",
                           "CALL LBL 2 REP 3",
                           "PLANE SPATIAL SPA+0 SPB+30 SPC+0",
                           "STOP G92 Z[1]"})
    EXPECT_EQ(effects(text), "?") << text;
  EXPECT_EQ(effects("M129"), "s");
}

TEST(MachineText, ReportsThatAControlMayLeaveThePath) {
  for (const char* text :
       {"G64", "G64 P0", "G64 P0.1", "G187", "G187 P3", "G187 E0.05", "G5 P10000", "G5.1 Q1", "G642", "CYCLE832(0.1)",
        "CYCLE832(0.5,_SEMIFIN,1)", "COMPCAD", "CYCL DEF 32.1 T0.05", "N10 G1 G187 P2"}) {
    EXPECT_TRUE(read_machine_text(text).smooths) << text;
    EXPECT_FALSE(read_machine_text(text).is_unknown) << text;
  }
  for (const char* text :
       {"G5 P0", "G5.1 Q0", "G61", "CYCLE832()", "CYCLE832(0,0,1)", "COMPOF", "CYCL DEF 32.0 TOLERANCE", "M8"})
    EXPECT_FALSE(read_machine_text(text).smooths) << text;
}

TEST(MachineText, TakesCommentsForComments) {
  EXPECT_EQ(effects("(G92 Z0)"), "");
  EXPECT_EQ(effects("M8 (COOLANT ON, Z-50)"), "");
  EXPECT_EQ(effects("M8 ; next tool"), "");
  EXPECT_EQ(effects("; change the clamp"), "");
  EXPECT_EQ(effects("M8 ; Z-50"), "?") << "elsewhere the next block";
  EXPECT_EQ(effects("; #100=5"), "?");
  for (const char* function : {"(UAO,2)", "(MIR,X)", "(RPT,3)", "(ERP)", "( CLS , SUB )"})
    EXPECT_EQ(effects(function), "?") << function << " of an Osai control";
}

TEST(MachineText, TakesNoSentenceForHarmless) {
  for (const char* text : {"ROT AND CLAMP THE PART", "PUT STOP AT X0 Y0", "CALL THE OPERATOR AT ONCE"})
    EXPECT_EQ(effects(text), "?") << text;
}

TEST(ToolName, HasADimensionOrAKindOfTool) {
  for (const char* name : {"[HOLDER=C40-M20EM3] 20MM CRB 2FL 38 LOC", "12MM X 60DEG HSS CENTERDRILL", "SPOTDRILL",
                           "T1 D10 R0.5", "M6 X 1.0 TAP", "1/2\" END MILL", "4.0mm JOBBER DRILL", "FRESA 10"})
    EXPECT_TRUE(is_tool_name(name)) << name;
  for (const char* name : {"TRANS MIRROR AXIS X", "#100=-12", "10MM #1=5", "GOTO 100", "VZOFZ=-12", "PRESET CORR Z-12"})
    EXPECT_FALSE(is_tool_name(name)) << name;
}

TEST(SetupText, IsStockOrAStopWithAMessage) {
  for (const char* text : {"Stock Size X95. Y150. Z120.", "STOP  change fixture", "STOP  Insert holdings"})
    EXPECT_TRUE(is_setup_text(text)) << text;
  for (const char* text : {"STOP", "STOP G92 Z0", "Stock Size X95. TRANS", "STOP #1=A", "Stock"})
    EXPECT_FALSE(is_setup_text(text)) << text;
}

}  // namespace
}  // namespace gouge::machine_text_test
