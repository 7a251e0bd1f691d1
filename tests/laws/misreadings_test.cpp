// Files that older readers took for clean, because a statement was overlooked: the cutter is in the part, or nobody
// knows where it is.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/toolpath_format.h"
#include "tests/laws/reading.h"

namespace gouge::misreadings_test {
namespace {

struct Misreading {
  const char* name;
  std::string text;
  const char* outcome;
};

void PrintTo(const Misreading& c, std::ostream* out) { *out << c.name; }

class Misread : public ::testing::TestWithParam<Misreading> {};

const auto kName = [](const auto& test) { return std::string(test.param.name); };

std::string apt(const std::string& body) { return "UNITS/MM\nCUTTER/10\nLOADTL/1\n" + body + "FINI\n"; }

std::string at_5(const std::string& statement) { return apt(statement + "GOTO/0,0,5\nGOTO/10,0,5\n"); }

std::string around(const std::string& statement) { return apt("GOTO/0,0,5\n" + statement + "GOTO/0,0,5\n"); }

std::string clt(const std::string& setup) {
  return "UNITS/ MM \nCUTTER/ 10,0,5,0,0,0,50,\n" + setup + "OPFEATSTART/x\nGOTO/ 0,0,5 \nGOTO/ 10,0,5 \nFINI \n";
}

std::string rotabl(const char* angle, const char* axis, const char* sense) {
  return std::string("ROTABL/ ") + angle + "," + axis + ",TABLE," + sense + "\n";
}

constexpr const char* kQuarter = "1.570796";
constexpr const char* kBack = "-1.570796";

INSTANTIATE_TEST_SUITE_P(Shift, Misread,
                         ::testing::Values(Misreading{"None", at_5(""), "clean"},
                                           Misreading{"Zero", at_5("TRANS/0,0.0,-0\nORIGIN/0,0,0\n"), "clean"},
                                           Misreading{"Undone", at_5("TRANS/0,0,5\nTRANS/0,0,0\n"), "clean"},
                                           Misreading{"OfFortran", at_5("TRANS/0,0,-1.D1\n"), "not-checked"},
                                           Misreading{"OriginOfFortran", at_5("ORIGIN/0,0,1.D1\n"), "not-checked"},
                                           Misreading{"ZeroOfFortran", at_5("TRANS/0.D0,.0D+0,0\n"), "clean"},
                                           Misreading{"PositionOfFortran", around("GOTO/0.D0,1.5d+1,-.2D-1\n"),
                                                      "gouge"},
                                           Misreading{"WordThatIsNoNumber", around("GOTO/0,0,1D1\n"), "path-number"},
                                           Misreading{"OfSymbols", at_5("TRANS/DX,DY,DZ\n"), "not-checked"},
                                           Misreading{"OfAMatrix", at_5("TRANS/M1\n"), "not-checked"},
                                           Misreading{"TurnOfFortran", at_5("ROTABL/AAXIS,9.D1\n"), "not-checked"},
                                           Misreading{"TurnOfASymbol", at_5("ROTHED/AAXIS,ANG1\n"), "not-checked"},
                                           Misreading{"TurnOfZero", at_5("ROTABL/0.0,AAXIS,TABLE,CLW\n"), "clean"},
                                           Misreading{"TrntypOfZero", at_5("TRNTYP/WORLD,0,0,0\n"), "clean"},
                                           Misreading{"Trntyp", at_5("TRNTYP/WORLD,0,0,-10\n"), "not-checked"},
                                           Misreading{"TrntypOfASymbol", at_5("TRNTYP/WORLD,X\n"), "not-checked"},
                                           Misreading{"ModeMill", at_5("MODE/MILL\n"), "clean"},
                                           Misreading{"ModeTurn", at_5("MODE/TURN\n"), "not-checked"},
                                           Misreading{"ModeTurnThenMill", at_5("MODE/TURN\nMODE/MILL\n"), "clean"}),
                         kName);

INSTANTIATE_TEST_SUITE_P(
    Clt, Misread,
    ::testing::Values(
        Misreading{"PlusZ", clt("TLAXIS/ 0.000000,0.000000,1.000000 \n"), "clean"},
        Misreading{"AxisAside", clt("TLAXIS/ 0.000000,-1.000000,0.000000 \n"), "not-checked"},
        Misreading{"AxisThatIsNoNumber", clt("TLAXIS/ A1\n"), "not-checked"},
        Misreading{"TurnUndone", clt(rotabl(kQuarter, "AAXIS", "CCLW") + rotabl(kBack, "AAXIS", "CCLW")), "clean"},
        Misreading{"TurnUndoneTheOtherWay", clt(rotabl(kQuarter, "AAXIS", "CCLW") + rotabl(kQuarter, "AAXIS", "CLW")),
                   "clean"},
        Misreading{"TurnDoubled", clt(rotabl(kQuarter, "AAXIS", "CCLW") + rotabl(kBack, "AAXIS", "CLW")),
                   "not-checked"},
        Misreading{"TurnsUndoneLastFirst",
                   clt(rotabl(kQuarter, "AAXIS", "CCLW") + rotabl(kQuarter, "BAXIS", "CCLW") +
                       rotabl(kBack, "BAXIS", "CCLW") + rotabl(kBack, "AAXIS", "CCLW")),
                   "clean"},
        Misreading{"TurnsUndoneFirstFirst",
                   clt(rotabl(kQuarter, "AAXIS", "CCLW") + rotabl(kQuarter, "BAXIS", "CCLW") +
                       rotabl(kBack, "AAXIS", "CCLW") + rotabl(kBack, "BAXIS", "CCLW")),
                   "not-checked"},
        Misreading{"TurnOfAHead", clt("ROTABL/ 1,AAXIS,HEAD,CCLW\nROTABL/ -1,AAXIS,HEAD,CCLW\n"), "not-checked"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Lines, Misread,
    ::testing::Values(
        Misreading{"Plain", around("COOLNT/ON\n"), "clean"},
        Misreading{"Apart", around("RAPID\nGOTO/0,0,-5\n"), "gouge"},
        Misreading{"Rapid", around("RAPID GOTO/0,0,-5\n"), "path-statement"},
        Misreading{"Coolant", around("COOLNT/ON GOTO/0,0,-5\n"), "path-statement"},
        Misreading{"Semicolon", around("SPINDL/1000,CLW;GOTO/0,0,-5\n"), "path-statement"},
        Misreading{"Feed", around("FEDRAT/100,MMPM,GOTO/0,0,-5\n"), "path-statement"},
        Misreading{"WithoutSlash", around("RAPID GOTO 0,0,-5\n"), "path-statement"},
        Misreading{"Dangling", around("COOLNT/ON,$\nGOTO/0,0,-5\n"), "path-statement"},
        Misreading{"DanglingRapid", around("RAPID $\nGODLTA/-10\n"), "path-statement"},
        Misreading{"DanglingUnknown", around("BLURB/A,$\nGOTO/0,0,-5\n"), "path-statement"},
        Misreading{"DanglingText", around("RAPID $ GO DOWN\nGOTO/0,0,-5\n"), "path-statement"},
        Misreading{"Cutcom", around("COOLNT/ON CUTCOM/LEFT\n"), "path-statement"},
        Misreading{"CutcomAfterAWord", around("RAPID;CUTCOM/LEFT\n"), "path-statement"},
        Misreading{"Deleted", around("/CUTCOM/LEFT\n"), "path-statement"},
        Misreading{"CreoComment", "$$* Pro/CLfile\n" + around("$$-> MFGNO / $\nGOTO/0,0,-5\n"), "path-statement"},
        Misreading{"CreoCommentWithADollar", "$$* Pro/CLfile\n" + around("$$-> MFGNO / A$B\nGOTO/0,0,-5\n"), "gouge"},
        Misreading{"TextOfPprint", around("PPRINT COOLNT/ON GOTO/0,0,-5 $\n"), "clean"},
        Misreading{"ShiftAfterAComment", at_5("TRANS/0,0,$ Z FOLLOWS\n-10\n"), "not-checked"},
        Misreading{"StepInLine", around("GOTO/0,0,$ DOWN\n-5\n"), "gouge"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Numbered, Misread,
    ::testing::Values(
        Misreading{"Step", around("N10 GODLTA/-10\nN20 GODLTA/10\n"), "gouge"},
        Misreading{"StepWithoutABlank", around("N10GODLTA/-10\nN20GODLTA/10\n"), "gouge"},
        Misreading{"Goto", around("10 GOTO/0,0,-5\n"), "gouge"},
        Misreading{"Label", around("LAB1) GOTO/0,0,-5\n"), "gouge"},
        Misreading{"Cutcom", around("N10 CUTCOM/LEFT\n"), "not-checked"},
        Misreading{"Cutter", around("LOADTL/2\nN10 CUTTER/40\nGOTO/60,0,-5\n"), "gouge"},
        Misreading{"CutterNotLoaded", around("N10 CUTTER/40\nGOTO/60,0,-5\n"), "not-checked"},
        Misreading{"Unit", "N10 UNITS/INCHES\nCUTTER/.1\nGOTO/0,0,1\nGOTO/1.9,0,1\nGOTO/1.9,0,-.1\nFINI\n", "gouge"},
        Misreading{"Text", around("N10 PPRINT A $\nGOTO/0,0,-5\n"), "gouge"},
        Misreading{"NoBreakSpace", around("CUTCOM\xa0/LEFT\n"), "not-checked"},
        Misreading{"NoBreakSpaceOfUtf8", around("TRANS\xc2\xa0/0,0,-10\n"), "not-checked"},
        Misreading{"Parted", around("CUT COM/LEFT\n"), "not-checked"},
        Misreading{"PartedGoto", around("GO TO/0,0,-5\n"), "gouge"}),
    kName);

std::string catia(const std::string& matrix) {
  return "$$ CATIA APT VERSION 1.0\n$$*CATIA0\n" + matrix +
         "PARTNO X\nMULTAX\nCUTTER/10\nLOADTL/1\nGOTO/0,0,5,0,0,1\nGOTO/10,0,5,0,0,1\nEND\n";
}

constexpr const char* kRows = "$$ 1 0 0 0\n$$ 0 1 0 0\n$$ 0 0 1 -10\n";
constexpr const char* kTwoRows = "$$ 1 0 0 0\n$$ 0 1 0 0\n";

INSTANTIATE_TEST_SUITE_P(
    Catia, Misread,
    ::testing::Values(Misreading{"Whole", catia(std::string("$$ name\n") + kRows), "gouge"},
                      Misreading{"Nameless", catia(kRows), "gouge"},
                      Misreading{"NamedLikeARow", catia(std::string("$$ 1 2 3 4\n") + kRows), "path-frame"},
                      Misreading{"NameOnly", catia("$$ name\n"), "path-frame"},
                      Misreading{"TwoRows", catia(std::string("$$ name\n") + kTwoRows), "path-frame"},
                      Misreading{"TwoNamelessRows", catia(kTwoRows), "path-frame"},
                      Misreading{"Nothing", catia(""), "path-frame"},
                      Misreading{"OfNoDialect", at_5(std::string("$$ *CATIA0\n$$ name\n") + kRows), "gouge"},
                      Misreading{"BehindPositions", around(std::string("$$ *CATIA0\n$$ name\n") + kRows),
                                 "not-checked"},
                      Misreading{"BackwardsOnACircle",
                                 around("TLON,GOBACK/(CIRCLE/0,10,5,10),ON,(LINE/0,20,5,1,2,5)\n"), "not-checked"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Bytes, Misread,
    ::testing::Values(
        Misreading{"CommentAndReturn", around("$$ plunge\rGOTO/0,0,-5\r"), "path-line-end"},
        Misreading{"PageEnd", around("COOLNT/ON\fGOTO/0,0,-5\n"), "path-line-end"},
        Misreading{"FileEnd", around("COOLNT/ON\x1aGOTO/0,0,-5\n"), "path-line-end"},
        Misreading{"ReturnsOnly", "UNITS/MM\rCUTTER/10\rGOTO/0,0,-5\r", "path-line-end"},
        Misreading{"PageOfItsOwn", around("\f\nCOOLNT/ON\f\n\fRAPID\r\r\n") + "\x1a", "clean"},
        Misreading{"FarDown", around(std::string(9000, '\n') + "RAPID\x0bGOTO/0,0,-5\n"), "path-line-end"},
        Misreading{"AcrossAStretch", around(std::string(8192 - 44, '\n') + "RAPID\rGOTO/0,0,-5\n"), "path-line-end"},
        Misreading{"MultaxAndANoBreakSpace", around("MULTAX/OFF\xa0\n"), "not-checked"},
        Misreading{"MultaxNoMore", around("MULTAX/NOMORE\n"), "not-checked"},
        Misreading{"MultaxOnAgain", around("MULTAX/NOMORE\nMULTAX/ON\nMULTAX\n"), "clean"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Words, Misread,
    ::testing::Values(Misreading{"Include", around("INCLUD/MORE\n"), "not-checked"},
                      Misreading{"Clear", around("GOCLER\n"), "not-checked"},
                      Misreading{"Loop", around("DO/10,I=1,5\nGODLTA/0,0,-1\n10)CONTIN\n"), "path-part-program"},
                      Misreading{"LoopOfWords", around("LOOPST\nGODLTA/0,0,-1\nLOOPND\n"), "path-part-program"},
                      Misreading{"Jump", around("A)GODLTA/0,0,-1\nJUMPTO/A\n"), "path-part-program"},
                      Misreading{"Condition", around("IF(A)10,20,30\n"), "path-part-program"},
                      Misreading{"Synonym", around("SYN/GT,GOTO,DZ,GODLTA\nDZ/-10\n"), "path-statement"},
                      Misreading{"SynonymOfNoWord", around("SYN/A,B\n"), "clean"},
                      Misreading{"Control", around("INSERT/G00 Z-10.\n"), "not-checked"},
                      Misreading{"ControlWithoutBlanks", around("INSERT N10G1X5\n"), "not-checked"},
                      Misreading{"ControlThatMovesNothing", around("INSERT/G17 G54\nINSERT/G40 M8\n"), "clean"},
                      Misreading{"TabInToolPath",
                                 "TOOL\tPATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nGOTO/0,0,5,0,1,0\nEND-OF-PATH\n"
                                 "TOOL  PATH/A,TOOL,C\nTLDATA/MILL,10,0,50,0,0\nGOTO/53,0,-5\nEND-OF-PATH\n",
                                 "gouge"}),
    kName);

std::string holes(const std::string& cycle) { return around(cycle + "GOTO/10,0,5\nCYCLE/OFF\n"); }

std::string creo(const std::string& body) {
  return "$$* Pro/CLfile\n$$-> FEATNO / 1\nUNITS / MM\nCUTTER / 10\nLOADTL / 1\nGOTO / 0, 0, 5\n" + body +
         "GOTO / 0, 0, 5\nFINI\n";
}

std::string block(const std::string& setup, const std::string& body) {
  return "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\n" + setup + "GOTO/0,0,5\n" + body + "END-OF-PATH\n";
}

std::string camplete(const std::string& second) {
  const std::string frame = "MCS/1,0,0,0,1,0,0,0,1,0,0,1\n";
  return "UNITS/MM\nCSI_TOOL_PATH/A\n" + frame + "CUTTER/10,0,0,0,0,0,50\nLOADTL/1\nGOTO/0,0,5\nCSI_TOOL_PATH/B\n" +
         second + "GOTO/10,0,5\nEND\nFINI\n";
}

std::string mori(const std::string& frame) {
  return "OPNAME/ A\nUNITS/ MM\n" + frame + "CUTTER/10\nTOOLNO/ 4\nGOTO/ 0,0,5\nGOTO/ 1,0,5\nEND/\n";
}

std::string tilted(const std::string& position) {
  return "MODE/MILL\nUNITS/MM\nMULTAX/ON\nCUTTER/10\nLOADTL/1\nGOTO/0,0,30,.6,0,.8\n" + position + "END\nFINI\n";
}

constexpr const char* kFrame = "MSYS/0,0,1,1,0,0,0,1,0\n";

INSTANTIATE_TEST_SUITE_P(
    Damaged, Misread,
    ::testing::Values(
        Misreading{"MotionAfterTheEnd", around("FINI\n"), "not-checked"},
        Misreading{"ProgramAfterTheEnd", around("FINI\nPARTNO NEXT\n"), "not-checked"},
        Misreading{"WholeProgramAfterTheEnd", around("FINI\nPARTNO NEXT\nUNITS/MM\nCUTTER/10\nLOADTL/1\n"),
                   "not-checked"},
        Misreading{"NextProgramWithoutAnEnd", around("PARTNO NEXT\n"), "not-checked"},
        Misreading{"InsertBehindAMessage", around("INSERT/MSG(\"X\") G91\n"), "not-checked"},
        Misreading{"InsertBehindTraori", around("INSERT/TRAORI Z-10\n"), "not-checked"},
        Misreading{"InsertBehindACycleThatDoesNothing", around("INSERT/CYCLE832(0.01) G91\n"), "not-checked"},
        Misreading{"InsertOfACycleThatDoesNothing", around("INSERT/CYCLE832(0.01)\n"), "clean"},
        Misreading{"InsertOfAMessageWithBrackets", around("INSERT/MSG(\"DRILL (X)\")\n"), "clean"},
        Misreading{"InsertOfASentence", around("INSERT/STOP FOR INSPECTION\n"), "not-checked"},
        Misreading{"InsertOfACallInASentence", around("INSERT/STOP M98 P1000\n"), "not-checked"},
        Misreading{"InsertOfHeidenhainTolerance", around("INSERT/CYCL DEF 32.1 T0.05\n"), "clean"},
        Misreading{"AuxfunWithAPosition", around("AUXFUN/20,50,-5\n"), "not-checked"},
        Misreading{"TlaxisBeforeMultaxOff", around("TLAXIS/-.6,0,.8\nGOTO/40,0,50\nMULTAX/OFF\n"), "not-checked"},
        Misreading{"BlockDelete", around("/GOTO/0,0,9\n"), "path-statement"},
        Misreading{"ModeOfMilling", around("MODE/MILL\n"), "clean"},
        Misreading{"ModeOfStepsMisspelt", around("MODE/INCREM\n"), "not-checked"},
        Misreading{"ModeOfNobodyKnowsWhat", around("MODE/FOO\n"), "not-checked"},
        Misreading{"ModeWithANumber", around("MODE/MILL,2\n"), "not-checked"},
        Misreading{"FeedsInTwoUnits",
                   "CUTTER/10\nLOADTL/1\nFEDRAT/10,IPM\nGOTO/0,0,5\nFEDRAT/500,MMPM\nGOTO/10,0,5\nFINI\n", "path-unit"},
        Misreading{"FeedsInTwoUnitsOfAFileThatNamesOne",
                   "UNITS/MM\nCUTTER/10\nLOADTL/1\nFEDRAT/10,IPM\nGOTO/0,0,5\nFEDRAT/500,MMPM\nGOTO/10,0,5\nFINI\n",
                   "clean"},
        Misreading{"FeedOfACycleInAnotherUnit",
                   "CUTTER/10\nLOADTL/1\nFEDRAT/10,IPM\nGOTO/0,0,15\nCYCLE/DRILL,FEDTO,1,MMPM,100,RAPTO,2\nGOTO/0,0,5\n"
                   "CYCLE/OFF\nFINI\n",
                   "path-unit"},
        Misreading{"Arc",
                   around("GOTO/110,0,5\nGOTO/110,0,-5\nCIRCLE/60,0,-5,0,0,1,50\nGOTO/60,-50,-5\nGOTO/60,-50,30\n"),
                   "not-checked"},
        Misreading{"ArcOfAnotherSlope", around("GOTO/0,-5,5\nARCSLP/-12\nCIRCLE/0,0,5,0,0,1,5\nGOTO/5,0,5\n"),
                   "not-checked"},
        Misreading{"ArcToGodlta", around("GOTO/0,-5,5\nCIRCLE/0,0,5,0,0,1,5\nGODLTA/5,5,0\n"), "not-checked"},
        Misreading{"ArcAtTheEndOfAFeature",
                   clt("OPFEATSTART/A\nGOTO/ 0,-5,5\nCIRCLE/ 0,0,5,0,0,1,5\nOPFEATEND/A\nGOTO/ 5,0,5\n"),
                   "not-checked"},
        Misreading{"WorldWithoutItsNumbers",
                   "PARTNO/A\nUNIT/MM\nCUTTER/10\nLOADTL/1\nTRNTYP/WORLD\nGOTO/0,0,5\nGOTO/9,0,5\nFINI\n",
                   "not-checked"},
        Misreading{"EndOfACutStatement", around("DWELL,0.5\n"), "not-checked"},
        Misreading{"CodeOfFourDigits", around("G0004\n"), "not-checked"},
        Misreading{"CutterStatedAgainInShort",
                   "UNITS/MM\nCUTTER/10,1,4,1,0,0,60\nGOTO/-70,0,-10\nCUTTER/10,1\nGOTO/70,0,-10\nFINI\n", "gouge"},
        Misreading{"ArcFreeEitherWay", around("GOTO/0,-5,5\nCIRCLE/0,0,5,0,0,1,5\nGOTO/5,0,5\n"), "clean"},
        Misreading{"ArcToSeveral", around("CIRCLE/0,5,5,0,0,1,5,CLOCKWISE\nGOTO/5,5,5,0,10,5,-5,5,5\n"), "not-checked"},
        Misreading{"CreoArc", creo("CIRCLE / 0, 5, 5, 0, 0, 1, 5\nGOTO / 5, 5, 5\n"), "clean"},
        Misreading{"CreoArcWithASenseWord", creo("CIRCLE / 0, 5, 5, 0, 0, 1, 5, CLOCKWISE\nGOTO / 5, 5, 5\n"),
                   "not-checked"},
        Misreading{"CreoArcWithNothingBetweenCommas", creo("CIRCLE / 0, 5, 5, 0, 0, 1, 5,,0,0,0\nGOTO / 5, 5, 5\n"),
                   "not-checked"},
        Misreading{"CreoArcOfTenNumbers", creo("CIRCLE / 0, 5, 5, 0, 0, 1, 5, 0, 0, 0\nGOTO / 5, 5, 5\n"),
                   "not-checked"},
        Misreading{"CreoArcOfAnAngleAndZeros", creo("CIRCLE / 0, 5, 5, 0, 0, 1, 5, 270, 0, 0, 0\nGOTO / 5, 5, 5\n"),
                   "not-checked"},
        Misreading{"CreoCommentWithALoadtl", creo("$$-> MFGNO / ALOADTL / 2\n"), "path-statement"},
        Misreading{"Cycle", holes("CYCLE/DRILL,FEDTO,1,RAPTO,2\n"), "clean"},
        Misreading{"CycleWithNothingBetweenCommas", holes("CYCLE/DRILL,,FEDTO,1,RAPTO,2\n"), "not-checked"},
        Misreading{"CycleWithTwoPointsInANumber", holes("CYCLE/DRILL,FEDTO,1,RAPTO,2,STEP,1.0.5\n"), "not-checked"},
        Misreading{"CycleWithoutAWord", holes("CYCLE/\n"), "not-checked"},
        Misreading{"CutcomBothWays", around("CUTCOM/ON,OFF\n"), "not-checked"},
        Misreading{"LoadMisspelt", around("LOAAD/TOOL,2\n"), "not-checked"},
        Misreading{"LoadGlued", around("LOADTOOL,2\n"), "not-checked"},
        Misreading{"LoadCutShort", around("LOAD/TOO\n"), "not-checked"},
        Misreading{"LoadtlCutShort", around("LOADTL/\n"), "not-checked"},
        Misreading{"UnitMisspelt", around("UINT/INCH\n"), "not-checked"},
        Misreading{"UnitGlued", around("UNITSINCHES\n"), "not-checked"},
        Misreading{"UnitAfterPositions", "CUTTER/1\nGOTO/0,0,1\nUNITS/INCHES\nGOTO/0,0,1\nFINI\n", "not-checked"},
        Misreading{"KnotWithoutANurbs", block("", "KNOT/1.0\n"), "path-statement"},
        Misreading{"NxFrame", block(kFrame, "GOTO/1,0,5\n"), "clean"},
        Misreading{"NxFrameAfterPositions", block("", std::string(kFrame) + "GOTO/1,0,5\n"), "not-checked"},
        Misreading{"NxFrameAfterAllPositions", block("", kFrame), "not-checked"},
        Misreading{"NxTldataInTheName", "TOOL PATH/A,TOOL,BTLDATA/MILL,10,0,50,0,0\nGOTO/0,0,5\nEND-OF-PATH\n",
                   "path-statement"},
        Misreading{"CampleteFrame", camplete("MCS/1,0,0,0,1,0,0,0,1,0,0,1\n"), "clean"},
        Misreading{"CampleteSectionWithoutItsFrame", camplete(""), "not-checked"},
        Misreading{"CampleteFrameAfterPositions", camplete("GOTO/0,0,5\nMCS/1,0,0,0,1,0,0,0,1,0,0,2\n"), "not-checked"},
        Misreading{"MoriFrame", mori("MCSYS/ NUM,1,POINT,0,0,0,VECTOR,1,0,0,VECTOR,0,1,0\n"), "clean"},
        Misreading{"MoriFrameMisspelt", mori("MCSYS/ NUM,1,POINT,0,0,0,VECTR,1,0,0,VECTOR,0,1,0\n"), "not-checked"},
        Misreading{"AutodeskAxis", tilted("MULTAX/OFF\nGOTO/0,0,40\n"), "clean"},
        Misreading{"AutodeskAxisCutShort", tilted("GOTO/0,0,40\n"), "not-checked"},
        Misreading{"CatiaCycleWithAnotherHeight",
                   "$$ CATIA APT VERSION 1.0\nCUTTER/10\nLOADTL/1\nGOTO/0,0,15\nCYCLE/DRILL,3,5,RAPTO,1\nGOTO/0,0,5\n"
                   "CYCLE/OFF\nEND\n",
                   "not-checked"}),
    kName);

TEST(ByteOrderMark, IsNoPartOfWhatShowsTheDialect) {
  const std::string mark = "\xef\xbb\xbf";
  for (const std::string text : {"REMARK x NCLCAM\n", "GOTO/0,0,5\n", "$$*CATIA0\n", "TOOL PATH/A,TOOL,B\n"})
    EXPECT_EQ(recognise_dialect(mark + text).id, recognise_dialect(text).id) << text;
  const std::string nci = "1001\n0 0. 0. 5.\n0\n0 0. 0. 5. -2. 0\n1\n0 0. 0. -5. 100. 0\n99\n0\n";
  const Toolpath read = read_as(mark + nci, "");
  EXPECT_EQ(read.dialect, "mastercam-nci");
  EXPECT_EQ(read.moves.size(), read_as(nci, "").moves.size());
}

TEST_P(Misread, IsNotTakenForClean) { EXPECT_EQ(outcome_at_box(GetParam().text), GetParam().outcome); }

}  // namespace
}  // namespace gouge::misreadings_test
