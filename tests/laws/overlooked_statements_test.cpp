// Statements that may move the tool or shift what follows and that older readers passed over: the cutter may
// be in the part, so the file is not clean. Beside them what moves nothing and must stay clean.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/laws/reading.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::overlooked_statements_test {
namespace {

/// A box whose top is z = 0.
std::string outcome(const std::string& text) {
  const ReadOutcome read = read_toolpath("a.apt", text);
  if (!read.toolpath) return read.errors.empty() ? "no error" : read.errors.front().code;
  Toolpath path = *read.toolpath;
  const IndexedMesh part = shapes::box({-50, -50, -20}, {50, 50, 0});
  const auto has_cutter = [&](const Move& move) {
    return move.tool != kNone && path.tools[move.tool].cutter.has_value();
  };
  if (std::all_of(path.moves.begin(), path.moves.end(), has_cutter)) return verdict(path, part);
  if (path.dialect != "mastercam-nci") return "no cutter";
  path.tools.resize(1);  // NCI files define none
  for (Move& move : path.moves) move.tool = 0;
  return verdict(path, part, {tools::ball(10)});
}

struct Overlooked {
  const char* name;
  std::string text;
  const char* outcome = "not-checked";
};

void PrintTo(const Overlooked& c, std::ostream* out) { *out << c.name; }

class Overlook : public ::testing::TestWithParam<Overlooked> {};

const auto kName = [](const auto& test) { return std::string(test.param.name); };

/// Between two positions above the part.
std::string around(const std::string& statement) {
  return "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,5\n" + statement + "GOTO/10,0,5\nGOTO/20,0,5\nFINI\n";
}

/// Before positions above the part, so that only a shift makes them doubtful.
std::string before(const std::string& statement) {
  return "UNITS/MM\nCUTTER/10\nLOADTL/1\n" + statement + "GOTO/0,0,5\nGOTO/10,0,5\nFINI\n";
}

/// With nothing after it.
std::string at_the_end(const std::string& statement) {
  return "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,5\nGOTO/10,0,5\n" + statement;
}

std::string creo(const std::string& body) {
  return "$$* Pro/CLfile\n$$-> UNITS / MM\nUNITS / MM\nCUTTER / 10.\nLOADTL / 1\n" + body + "FINI\n";
}

std::string solidworks(const std::string& statement) {
  return "TRNTYP/WORLD,0,0,0\nUNIT/MM\nCUTTER/10.,0,5.,0,0,0,40.\nLOAD/TOOL,1\nGOTO/0,0,5.\n" + statement +
         "GOTO/10.,0,5.\nFINI\n";
}

std::string nci(const std::string& pair) {
  return "1002\n1 1 0 1 0\n0\n0 0. 0. 5. -2. 0\n" + pair + "1\n0 10. 0. 5. 100. 0\n1003\n0\n";
}

INSTANTIATE_TEST_SUITE_P(
    LineOfNumbers, Overlook,
    ::testing::Values(
        Overlooked{"AxisOfCreo", creo("MULTAX / ON\nGOTO / 0., 0., 5., 0., 0., 1.\nGOTO / 10., 0., 5.,\n"
                                      "0.7071067812, 0.0, 0.7071067812\n")},
        Overlooked{"AxisOfCreoInOrder",
                   creo("MULTAX / ON\nGOTO / 0., 0., 5., 0., 0., 1.\nGOTO / 10., 0., 5., $\n"
                        "0.0, 0.0, 1.0\n"),
                   "clean"},
        Overlooked{"AxisGone", creo("MULTAX / ON\nGOTO / 0., 0., 5., 0., 0., 1.\nGOTO / 10., 0., 5.,\n"
                                    "GOTO / 0., 0., 5., 0., 0., 1.\n")},
        Overlooked{"ListGoesOn", around("GOTO/0,0,5,1,0,5,2,0,5\n0,0,-5,0,1,-5\n")},
        Overlooked{"ListGoesOnAtTheEnd", at_the_end("GOTO/0,0,5,1,0,5,2,0,5\n0,0,-5\n")},
        Overlooked{"Blanks", around("20. 0. -25.\n")}, Overlooked{"BlanksAtTheEnd", at_the_end("20. 0. -25.\n")},
        Overlooked{"Commas", around("20.,0.,-25.\n")}, Overlooked{"Tabs", around("\t20.\t0.\t-25.\n")},
        Overlooked{"OneNumber", around("-25.\n")}, Overlooked{"Plus", around("+.5 0 -25\n")},
        Overlooked{"Point", around(".5,0,-2.5D+1\n")}, Overlooked{"InBrackets", around("(0,0,-50.)\n")},
        Overlooked{"CommaFirst", around(",0,0,-50.\n")}, Overlooked{"Deleted", around("/20.,0.,-25.\n")},
        Overlooked{"AfterASequenceNumber", around("N10 20.,0.,-25.\n")},
        Overlooked{"AfterANumber", around("10 20. 0. -25.\n")}, Overlooked{"AfterALabel", around("LAB1) -25.\n")},
        Overlooked{"AfterAComment", around("GOTO/0,0,5,\n$$ the axis\n0.6,0,0.8\n")},
        Overlooked{"OfWideDigits", around("\xef\xbc\x92\xef\xbc\x90,0,-25.\n")},
        Overlooked{"OfACutter", "UNITS/MM\nCUTTER/10,0\n5,5,0,0,40\nLOADTL/1\nGOTO/0,0,5\nGOTO/10,0,5\nFINI\n",
                   "no cutter"},
        Overlooked{"OfAShift", before("TRANS/0,0\n-10\n")}, Overlooked{"OfACycle", around("CYCLE/OFF,\n")},
        Overlooked{"ShiftCutShort", before("TRANS/0,0,\n")},
        Overlooked{"OfACutterLost", before("PPRINT/A\n0.0, 40.0\n")}, Overlooked{"OfAFeed", around("300.0, MMPM\n")},
        Overlooked{"MinorWord", around("OFF\n")}, Overlooked{"RestOfACycle", around("RETURN,    0.000000\n")},
        Overlooked{"SlashAndAWord", around("/OFF\n")}, Overlooked{"SlashAndAUnit", around("/MM\n")},
        Overlooked{"LineEndLostAfterADigit", around("FEDRAT/ MMPM,187.16GOTO/1,2,3\n"), "path-statement"},
        Overlooked{"LineEndLostAfterAWord", around("SPINDL/OFFCYCLE/OFF\n"), "path-statement"},
        Overlooked{"LineEndLostBeforeAStep", around("COOLNT/ONGODLTA/-5\n"), "path-statement"},
        Overlooked{"DollarForTwo",
                   "$ CATIA APT VERSION 1.0\n$$*CATIA0\n$$ A\n$$ 1 0 0 0\n$$ 0 1 0 0\n$$ 0 0 1 -10\n"
                   "PARTNO A\nMULTAX\nCUTTER/10\nLOADTL/1\nGOTO/0,0,5,0,0,1\nGOTO/10,0,5,0,0,1\nEND\n",
                   "path-statement"},
        Overlooked{"TextWithAComma", around("PPRINT/A,\n"), "clean"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Glued, Overlook,
    ::testing::Values(
        Overlooked{"Brackets", around("GOTO(0,0,-50.)\n")}, Overlooked{"Minus", around("GOTO-1.,0,-50.\n")},
        Overlooked{"Digits", around("GOTO20.,0.,-25.\n")}, Overlooked{"Step", around("GODLTA-50.\n")},
        Overlooked{"StepInBrackets", around("GODLTA(-50.)\n")}, Overlooked{"StepUp", around("GODLTA+50\n")},
        Overlooked{"Small", around("goto(0,0,-50.)\n")}, Overlooked{"Colon", around("GOTO:0,0,-50.\n")},
        Overlooked{"PartedWords", around("GO TO 0 0 -5\n")}, Overlooked{"PartedStep", around("GO DLTA -50.\n")},
        Overlooked{"AtTheEnd", at_the_end("GODLTA-50.\n")}, Overlooked{"From", around("FROM(0,0,-50.)\n")},
        Overlooked{"Home", around("GOHOME(0,0,-50.)\n")}, Overlooked{"Rapid", around("RAPID 0,0,-50\n")},
        Overlooked{"RapidAndABlock", around("RAPID;G1 Z-50\n")},
        Overlooked{"WideLetters", around("\xef\xbc\xa7\xef\xbc\xaf\xef\xbc\xb4\xef\xbc\xaf/0,0,-50\n")},
        Overlooked{"BesideCoolant", around("COOLNT/ON GODLTA-50.\n"), "path-statement"},
        Overlooked{"BlockBesideCoolant", around("COOLNT/ON G1 Z-50.\n"), "path-statement"},
        Overlooked{"Shift", before("TRANS(0,0,-50)\n")}, Overlooked{"Unit", before("UNITS(INCHES)\n")},
        Overlooked{"Cutter", before("CUTTER(20)\n"), "no cutter"},
        Overlooked{"CutterDigits", before("CUTTER20.\n"), "no cutter"},
        Overlooked{"Compensation", around("CUTCOM(LEFT)\n")}, Overlooked{"Cycle", around("CYCLE(DRILL,FEDTO,-15)\n")},
        Overlooked{"Axes", around("MULTAX:OFF\n")}, Overlooked{"Circle", around("CIRCLE(0,10,5,0,0,1,10)\n")},
        Overlooked{"Tool", around("LOADTL(2)\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Misspelt, Overlook,
    ::testing::Values(
        Overlooked{"Missing", around("GODLT/-50\n")}, Overlooked{"Wrong", around("GODLTS/50\n")},
        Overlooked{"TooMany", around("GODLLTA/50\n")}, Overlooked{"Swapped", around("OGTO/0,0,-50\n")},
        Overlooked{"Shift", before("TRNS/0,0,-50\n")}, Overlooked{"ShiftSwapped", before("TARNS/5\n")},
        Overlooked{"Cutter", before("CUTER/20\n"), "no cutter"}, Overlooked{"Compensation", around("CUTCM/LEFT\n")},
        Overlooked{"Cycle", around("CYCE/DRILL,FEDTO,15\n")}, Overlooked{"Axes", around("MULTX/OFF\n")},
        Overlooked{"Unit", before("UNTS/INCHES\n")}, Overlooked{"Loading", around("LOADT/2\n")},
        Overlooked{"LoadingOfATool", around("LOA/TOOL,2\n")}, Overlooked{"Arc", around("CIRCL/0,10,5,0,0,1,10\n")},
        Overlooked{"Retract", at_the_end("RETRACT\n")}, Overlooked{"ToolPath", before("TOOL PTH/A,TOOL,B\n")},
        Overlooked{"OffWithoutASlash", around("CYCLEOFF\n")}, Overlooked{"LeftWithoutASlash", around("CUTCOMLEFT\n")},
        Overlooked{"CycleAlone", around("CYCLE/\n")}, Overlooked{"LoadingAlone", around("LOADTL/\n")},
        Overlooked{"LoadingOfAnother", around("LOAD/TOL,2\n")}, Overlooked{"ShiftAlone", before("TRANS/\n")},
        Overlooked{"TurnAlone", before("ROTABL/\n")}, Overlooked{"TurnWithoutAnAngle", before("ROTHED/AAXIS,ATANGL\n")},
        Overlooked{"WordLikeMode", around("MODEL/A\n")}, Overlooked{"OtherWord", around("FEATURE/12\n")},
        Overlooked{"NegativeNumber", around("ZSTEP/-50\n")}, Overlooked{"UnknownShift", before("DATUM/0,0,-50\n")},
        Overlooked{"Move", around("MOVE/50.\n")},
        Overlooked{"UnknownAtTheEnd", at_the_end("BLURB/1,0,0,0,1,0,0,0,1\n")},
        Overlooked{"CopyAtTheEnd", at_the_end("COPY/1,TRANSL,0,0,-50,1\nFINI\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Block, Overlook,
    ::testing::Values(Overlooked{"Line", around("G1 X0 Y0 Z-50.\n")}, Overlooked{"Modal", around("X20. Y0. Z-12.\n")},
                      Overlooked{"OneAxis", around("Z-12.\n")}, Overlooked{"Numbered", around("N10 G1X5\n")},
                      Overlooked{"Deleted", around("/G1 Z-50\n")}, Overlooked{"AtTheEnd", at_the_end("G0Z-50\n")},
                      Overlooked{"Arguments", around("FOO/X20,Y0,Z-12\n")},
                      Overlooked{"Equals", around("N20 Z=-12.\n")}, Overlooked{"Colon", around("Z:-50\n")},
                      Overlooked{"WordAndAStep", around("DOWN-50.\n")},
                      Overlooked{"BesideTheSpindle", around("SPINDL/1000 Z-50\n"), "path-statement"},
                      Overlooked{"Turn", around("A90.\n")},
                      Overlooked{"Switch", around("N10 M8 S1000 F200\n"), "clean"},
                      Overlooked{"Tool", around("T5 M6\n")}, Overlooked{"Comment", around("(MSG, NEXT)\n")},
                      Overlooked{"Percent", around("%\nO1234\n"), "clean"}, Overlooked{"Call", around("M98 P100\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    NumbersBehind, Overlook,
    ::testing::Values(
        Overlooked{"Coolant", around("COOLNT/ON,0,0,-5\n")}, Overlooked{"CoolantAbove", around("COOLNT/ON,0,0,5\n")},
        Overlooked{"CoolantsNegative", around("COOLNT/ON,-5\n")}, Overlooked{"Feed", around("FEDRAT/100,0,0,-5\n")},
        Overlooked{"FeedAndAUnit", around("FEDRAT/MMPM,100.,0,0,5\n")}, Overlooked{"Stop", around("STOP/0,0,-50\n")},
        Overlooked{"Spindle", around("SPINDL/RPM,1000.,CLW,0,0,-5\n")},
        Overlooked{"SpindleBackwards", around("SPINDL/-1000\n"), "clean"},
        Overlooked{"SpindleOfARange", around("SPINDL/1000,RPM,CLW,RANGE,2\n"), "clean"},
        Overlooked{"FeedOfAUnit", around("FEDRAT/MMPM,100.\n"), "clean"},
        Overlooked{"Sequence", around("SEQNO/10,INCR,5\n"), "clean"},
        Overlooked{"Box", around("BOX/0,-10,0,10,20,30\n"), "clean"}, Overlooked{"Tool", around("TOOL/5\n")},
        Overlooked{"Offset", around("OFFSET/5\n")}, Overlooked{"Head", around("HEAD/2\n")},
        Overlooked{"OffsetOfAName", around("OFFSET/ON\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Setup, Overlook,
    ::testing::Values(
        Overlooked{"Shift", before("SETUP/0,0,-50\n")}, Overlooked{"Number", before("SETUP/2\n")},
        Overlooked{"Mark", before("SETUP/START,1\nSETUP/END,1\n"), "clean"},
        Overlooked{"Zero", before("SETUP/0,0,0\n"), "clean"}, Overlooked{"Name", before("SETUP/FIRST\n")},
        Overlooked{"ZeroOfTheProgram", before("ZERO/0,0,50\n")},
        Overlooked{"ZeroOfTheProgramAtZero", before("ZERO/0,0,0\n"), "clean"},
        Overlooked{"Steps", before("MODE/INCR\n")}, Overlooked{"StepsThenMilling", before("MODE/INCR\nMODE/MILL\n")},
        Overlooked{"StepsOfCoordinates", before("COORD/INCR\n")}, Overlooked{"ReferenceSystem", before("REFSYS/M1\n")},
        Overlooked{"Origin", before("SELECT/ORIGIN,2\n")}, Overlooked{"Head", before("SELECT/HEAD,2\n")},
        Overlooked{"NextTool", before("SELECT/TOOL,2\n"), "clean"},
        Overlooked{"ThenAFrame", before("SELECT/ORIGIN,2\nMSYS/0,0,0,1,0,0,0,1,0\n"), "clean"},
        Overlooked{"Preparatory", before("PREFUN/92\n")},
        Overlooked{"PreparatoryPlane", before("PREFUN/17\n"), "clean"},
        Overlooked{"PreparatorySteps", before("PREFUN/91\n")}, Overlooked{"PreparatoryHome", around("PREFUN/28\n")},
        Overlooked{"PreparatoryOther", around("PREFUN/999\n")}, Overlooked{"Auxiliary", around("AUXFUN/8\n"), "clean"},
        Overlooked{"AuxiliaryCall", around("AUXFUN/98\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Insert, Overlook,
    ::testing::Values(
        Overlooked{"Preset", before("INSERT/G92 X0 Y0 Z0\n")}, Overlooked{"Local", before("INSERT/G52 Z-50.\n")},
        Overlooked{"Plane", before("INSERT/G68.2 X0 Y0 Z0 I0 J30 K0\n")},
        Overlooked{"Data", before("INSERT/G10 L2 P1 Z-50.\n")}, Overlooked{"Trans", before("INSERT/TRANS Z-50\n")},
        Overlooked{"AddTrans", before("INSERT/ATRANS Z-50\n")}, Overlooked{"Rot", before("INSERT/ROT RPL=45\n")},
        Overlooked{"Cycle800", before("INSERT/CYCLE800(1,\"\",0,57)\n")},
        Overlooked{"Trafoof", before("INSERT/TRAFOOF\n")},
        Overlooked{"Mcall", around("INSERT/MCALL CYCLE81(10,0,1,-50)\n")},
        Overlooked{"McallEnds", around("INSERT/MCALL\n"), "clean"},
        Overlooked{"Cycle", around("INSERT/CYCLE81(10,0,1,-50)\n")}, Overlooked{"Machine", around("INSERT/G53 Z0\n")},
        Overlooked{"Home", around("INSERT/G28 G91 Z0\n")}, Overlooked{"HomeFirst", around("INSERT/G91 G28 Z0.\n")},
        Overlooked{"Steps", before("INSERT/G91\n")},
        Overlooked{"StepsEnd", before("INSERT/G91\nINSERT/G90\n"), "clean"},
        Overlooked{"Canned", around("INSERT/G81 Z-10. R2. F100\n")}, Overlooked{"CannedAlone", around("INSERT/G81\n")},
        Overlooked{"CannedEnds", before("INSERT/G81\nINSERT/G80\n"), "clean"},
        Overlooked{"Modal", around("INSERT/Z-50.\n")}, Overlooked{"ModalWithoutASlash", around("INSERT Z-50.\n")},
        Overlooked{"Comma", around("INSERT/Z-50,5\n")}, Overlooked{"Turn", before("INSERT/G0 B45.\n")},
        Overlooked{"Inch", before("INSERT/G20\n")}, Overlooked{"Metric", before("INSERT/G21\n"), "clean"},
        Overlooked{"Compensation", before("INSERT/G41 D1\n")}, Overlooked{"Call", around("INSERT/M98 P1000\n")},
        Overlooked{"Macro", around("INSERT/G65 P9810 Z-50.\n")}, Overlooked{"Variable", around("INSERT/#100=5\n")},
        Overlooked{"Jump", around("INSERT/IF [#1 EQ 0] GOTO 10\n")}, Overlooked{"UnknownCode", around("INSERT/G999\n")},
        Overlooked{"Subprogram", around("INSERT/MYSUB(0,-50)\n")}, Overlooked{"Name", around("INSERT/L100\n")},
        Overlooked{"Quoted", around("INSERT/\"G1 Z-50\"\n")}, Overlooked{"Blanks", around("INSERT/G 1 Z - 50\n")},
        Overlooked{"Expression", around("INSERT/G1 Z[-50]\n")}, Overlooked{"OfAVariable", around("INSERT/G1 Z#100\n")},
        Overlooked{"StepOfSiemens", around("INSERT/G1 Z=IC(-5)\n")}, Overlooked{"Supa", around("INSERT/SUPA Z0\n")},
        Overlooked{"LengthOff", before("INSERT/G49\n")},
        Overlooked{"LengthOffBeforeATool", before("INSERT/G40 G49 G80\nLOADTL/1\n"), "clean"},
        Overlooked{"GoTo", around("INSERT/GOTO 10\n")}, Overlooked{"ToolChange", around("INSERT/T2 M6\n")},
        Overlooked{"Heidenhain", around("INSERT/L Z-50 FMAX\n")},
        Overlooked{"HeidenhainStep", around("INSERT/12 L IZ-50 R0 F MAX\n")},
        Overlooked{"HeidenhainCycle", before("INSERT/CYCL DEF 7.1 Z-50\n")},
        Overlooked{"HeidenhainCall", around("INSERT/CYCL CALL M3\n")},
        Overlooked{"HeidenhainPlane", before("INSERT/PLANE SPATIAL SPA+0 SPB+30 SPC+0\n")},
        Overlooked{"HeidenhainTool", around("INSERT/TOOL CALL 5 Z S2000\n")},
        Overlooked{"HeidenhainTcpmOff", before("INSERT/M129\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    OtherOffset, Overlook,
    ::testing::Values(
        Overlooked{"First", around("INSERT/G55\n")}, Overlooked{"Second", around("INSERT/G54\nINSERT/G55\n")},
        Overlooked{"Back", around("INSERT/G54\nINSERT/G55\nINSERT/G90 G54\n"), "clean"},
        Overlooked{"Extended", around("INSERT/G54.1 P3\n")}, Overlooked{"Prefun", around("PREFUN/54\nPREFUN/55\n")},
        Overlooked{"Off", around("INSERT/G500\n")},
        Overlooked{"Heidenhain",
                   around("INSERT/CYCL DEF 247 DATUM SETTING Q339=1\nINSERT/CYCL DEF 247 DATUM SETTING Q339=2\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    InsertThatMovesNothing, Overlook,
    ::testing::Values(
        Overlooked{"Offset", around("INSERT/G54\n"), "clean"},
        Overlooked{"OffsetsBeforePositions", before("INSERT/G54\nINSERT/G90 G55 M8\n"), "clean"},
        Overlooked{"Safe", around("INSERT/N5 G17 G40 G80 G90\n"), "clean"},
        Overlooked{"Switches", around("INSERT/M8\nINSERT/M03 S12000\nINSERT/F200.\nINSERT/M0\n"), "clean"},
        Overlooked{"Dwell", around("INSERT/G4 X2.5\n"), "clean"},
        Overlooked{"Smoothing", around("INSERT/G5.1 Q1\nINSERT/G05 P10000\n"), "clean"},
        Overlooked{"Comment", around("INSERT/(CHECK Z-50. G92 X0)\nINSERT/; next tool\n"), "clean"},
        Overlooked{"Message", around("INSERT/MSG(\"TOOL 5\")\nINSERT/STOPRE\nINSERT/CYCLE832(0.01,1,1)\n"), "clean"},
        Overlooked{"TextOfSolidWorks", solidworks("INSERT/STOP  change fixture\nINSERT/Stock Size X95. Y150. Z120.\n"),
                   "clean"},
        Overlooked{"HeidenhainSwitch", around("INSERT/L M8\nINSERT/CYCL DEF 32.1 T0.01\n"), "clean"},
        Overlooked{"Empty", around("INSERT\nINSERT/\n"), "clean"},
        Overlooked{"ToolNames",
                   solidworks("INSERT/[HOLDER=C40-M20EM3] 20MM CRB 2FL 38 LOC\nCUTTER/10.,0,5.,0,0,0,40.\n"
                              "INSERT/M6 X 1.0 TAP\n$$ a comment\nCUTTER/10.,0,5.,0,0,0,40.\n"
                              "INSERT/Stock Size X172.48 Y39. Z34.\n"),
                   "clean"}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    InsertElsewhere, Overlook,
    ::testing::Values(Overlooked{"SolidWorksPreset", solidworks("INSERT/G92 Z0\n")},
                      Overlooked{"SolidWorksLine", solidworks("INSERT/G1 Z-50.\n")},
                      Overlooked{"SolidWorksModal", solidworks("INSERT/Z-50.\n")},
                      Overlooked{"SolidWorksMacro", solidworks("INSERT/#100=-12\n")},
                      Overlooked{"SolidWorksMirror", solidworks("INSERT/TRANS MIRROR AXIS X\n")},
                      Overlooked{"SolidWorksNameWithoutACutter", solidworks("INSERT/20MM CRB 2FL\nGOTO/5.,0,5.\n")},
                      Overlooked{"SolidWorksMacroBeforeACutter",
                                 solidworks("INSERT/#1=10MM\nCUTTER/10.,0,5.,0,0,0,40.\n")},
                      Overlooked{"NciEntry", nci("1006\nG92 Z0\n")},
                      Overlooked{"NciComment", nci("1005\n(ROUGHING OF X)\n"), "clean"},
                      Overlooked{"NciMacro", nci("1005\n#100=-12\n")}, Overlooked{"NciCode", nci("1030\n1 2 3\n")},
                      Overlooked{"NciStock", nci("1020\n0 0 0 10. 10. 10.\n"), "clean"},
                      Overlooked{"NciUnharmed", nci(""), "clean"}),
    kName);

TEST_P(Overlook, IsNeverTakenForClean) { EXPECT_EQ(outcome(GetParam().text), GetParam().outcome); }

TEST(WorkOffset, IsReported) {
  const ReadOutcome read = read_toolpath("a.apt", around("INSERT/G54\n"));
  ASSERT_TRUE(read.toolpath);
  const Diagnostics& notes = read.toolpath->notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [](const Diagnostic& n) { return n.code == "path-machine-text" && n.line == 5; }));
}

// The position after a motion of unknown end stands alone, and from there on all is known again.
TEST(MotionOfUnknownEnd, MakesOneMoveMoreNotChecked) {
  for (const std::string statement : {"20. 0. -25.\n", "G1 Z-50.\n", "INSERT/G53 Z0\n", "INSERT/L Z-50 FMAX\n"}) {
    const ReadOutcome read = read_toolpath("a.apt", around("FEDRAT/100,MMPM\n" + statement));
    ASSERT_TRUE(read.toolpath) << statement;
    std::vector<bool> is_checked;
    for (const Move& move : read.toolpath->moves) is_checked.push_back(move.not_checked_reason.empty());
    EXPECT_EQ(is_checked, (std::vector<bool>{true, false, false, true})) << statement;
  }
}

TEST(LineOfNumbersAfterAPosition, LeavesItWithoutAnAxisToTrust) {
  const ReadOutcome read = read_toolpath("a.apt", around("GOTO/5,0,5\n$$ a comment\n0.6,0,0.8\n"));
  ASSERT_TRUE(read.toolpath);
  EXPECT_EQ(read.toolpath->moves.at(1).not_checked_reason, Reasons::kCutShort);
  EXPECT_TRUE(read.toolpath->moves.at(0).not_checked_reason.empty());
}

}  // namespace
}  // namespace gouge::overlooked_statements_test
