// Words that no reader here knows inside statements that are known, and ways between positions that no statement
// defines: the part would be cut if they meant what other post-processors mean by them, so none is clean.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "postproc/formats/read_toolpath.h"
#include "tests/laws/reading.h"

namespace gouge::unknown_words_test {
namespace {

struct Wording {
  const char* name;
  std::string text;
  const char* outcome = "not-checked";
};

void PrintTo(const Wording& c, std::ostream* out) { *out << c.name; }

class UnknownWord : public ::testing::TestWithParam<Wording> {};

const auto kName = [](const auto& test) { return std::string(test.param.name); };

std::string apt(const std::string& body) { return "UNITS/MM\nCUTTER/10,0,0,0,0,0,60\nLOADTL/1\n" + body + "FINI\n"; }

std::string around(const std::string& statement) {
  return apt("GOTO/0,0,30\n" + statement + "GOTO/10,0,30\nGOTO/20,0,30\n");
}

std::string hole(const std::string& cycle) { return apt("GOTO/0,0,30\n" + cycle + "GOTO/10,0,20\nCYCLE/OFF\n"); }

std::string nx(const std::string& body) {
  return "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nGOTO/0,0,30\n" + body + "END-OF-PATH\n";
}

std::string nx_hole(const std::string& words) {
  return nx("CYCLE/DRILL,RAPTO,20,FEDTO,-1,RTRCTO,20" + words + "\nGOTO/10,0,20\nCYCLE/OFF\n");
}

std::string catia_hole(const std::string& cycle) {
  return "$$ CATIA APT VERSION 1.0\nUNITS/MM\nCUTTER/10,0,5,0,0,0,50\nLOADTL/1\nGOTO/0,0,30\n" + cycle +
         "GOTO/10,0,20\nCYCLE/OFF\nEND\n";
}

INSTANTIATE_TEST_SUITE_P(
    Cycle, UnknownWord,
    ::testing::Values(Wording{"None", nx_hole(""), "clean"}, Wording{"Known", nx_hole(",DWELL,2,MMPM,100"), "clean"},
                      Wording{"Pecks", hole("CYCLE/DEEP,FEDTO,5,STEP,1,MMPM,100,RAPTO,2,RTRCTO,5\n"), "clean"},
                      Wording{"DeepBesideDrill", nx_hole(",DEEP"), "clean"},
                      Wording{"Invented", nx_hole(",FOOBAR,-50")}, Wording{"Bottom", nx_hole(",ZBOTTOM,-9")},
                      Wording{"Top", nx_hole(",TOP,-20")}, Wording{"Cam", nx_hole(",CAM,-9")},
                      Wording{"Offset", nx_hole(",OFFSET,50")}, Wording{"Through", nx_hole(",THRU,50")},
                      Wording{"Code", nx_hole(",G81")}, Wording{"Tip", nx_hole(",TIP,50")},
                      Wording{"Diameter", nx_hole(",DIAMET,50")}, Wording{"Letter", nx_hole(",R,3")},
                      Wording{"WordAlone", nx_hole(",MANUALLY")}, Wording{"TwoDwells", nx_hole(",DWELL,2,-50")},
                      Wording{"Apt", hole("CYCLE/DRILL,FEDTO,5,RAPTO,2,THRU,50\n")},
                      Wording{"RetractBelowTheClearance", hole("CYCLE/DRILL,FEDTO,5,RAPTO,9,RTRCTO,2\n")},
                      Wording{"RetractAtTheClearance", hole("CYCLE/DRILL,FEDTO,5,RAPTO,9,RTRCTO,9\n"), "clean"},
                      Wording{"CatiaNumbers", catia_hole("CYCLE/DRILL,1.,3.\n"), "clean"},
                      Wording{"CatiaFeedBeforeItsUnit", catia_hole("CYCLE/DRILL,1.,100.,MMPM,3.\n")},
                      Wording{"CatiaThreeNumbers", catia_hole("CYCLE/DRILL,1.,100.,3.\n")},
                      Wording{"CatiaNoClearance", catia_hole("CYCLE/DRILL,1.,100.,MMPM\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(
    Statement, UnknownWord,
    ::testing::Values(Wording{"Rapid", around("RAPID\n"), "clean"}, Wording{"RapidOfAPlane", around("RAPID/XYPLAN\n")},
                      Wording{"RapidModified", around("RAPID/MODIFY,XAXIS\n")},
                      Wording{"ModeOfAnotherUnit", around("MODE/METRIC\n")}, Wording{"ModeInch", around("MODE/INCH\n")},
                      Wording{"ModeMill", around("MODE/MILL\n"), "clean"}, Wording{"ToolOfANumber", around("TOOL/2\n")},
                      Wording{"ToolOfADiameter", around("TOOL/MILL,40\n")},
                      Wording{"ToolnoOfTheCutter", apt("TOOLNO/1,10\nGOTO/0,0,30\n"), "clean"},
                      Wording{"ToolnoOfAnotherDiameter", apt("TOOLNO/1,40\nGOTO/0,0,30\n")},
                      Wording{"ToolnoOfAnotherDiameterAndNumber", apt("TOOLNO/1,40,4\nGOTO/0,0,30\n")},
                      Wording{"ToolnoOfAnUnknownNumber", apt("TOOLNO/1,10,4\nGOTO/0,0,30\n")},
                      Wording{"ToolnoOfAnotherMill", apt("TOOLNO/1,MILL,1,0,40\nGOTO/0,0,30\n")},
                      Wording{"Compensation", around("TLCOMP/LEFT\n")}, Wording{"Steps", around("INCREM\n")},
                      Wording{"Tilt", around("HEADTILT/30\n")}, Wording{"Axis", around("BAXIS/45\n")},
                      Wording{"ShiftOfZ", around("ZSHIFT/5\n")}, Wording{"Feature", around("FEATURE/12\n")},
                      Wording{"Alone", around("QUILL\n")}, Wording{"AfterAllPositions", apt("GOTO/0,0,30\nQUILL\n")},
                      Wording{"BeforeAllPositions", apt("QUILL\nGOTO/0,0,30\n")},
                      Wording{"BeforeTheProgram", "WRITTEN BY A SYSTEM\nPARTNO A\n" + around(""), "clean"},
                      Wording{"BetweenProgramAndPositions", "PARTNO A\nSYSTEM/2\n" + around("")}),
    kName);

INSTANTIATE_TEST_SUITE_P(Machine, UnknownWord,
                         ::testing::Values(Wording{"CallOfOkuma", nx("INSERT/CALL O1000\nGOTO/10,0,30\n")},
                                           Wording{"CallOfALetter", nx("INSERT/CALL L1\nGOTO/10,0,30\n")},
                                           Wording{"CallInASentence",
                                                   nx("INSERT/CALL THE OPERATOR AT ONCE\nGOTO/10,0,30\n")},
                                           Wording{"Extcall", nx("INSERT/EXTCALL ABC\nGOTO/10,0,30\n")},
                                           Wording{"Modin", nx("INSERT/MODIN O1\nGOTO/10,0,30\n")},
                                           Wording{"Pcall", nx("INSERT/PCALL ABC\nGOTO/10,0,30\n")},
                                           Wording{"Repeat", nx("INSERT/REPEAT A B\nGOTO/10,0,30\n")},
                                           Wording{"Selected", nx("INSERT/SEL PGM \"A\"\nGOTO/10,0,30\n")},
                                           Wording{"LengthOff", nx("INSERT/D0\nGOTO/10,0,30\n")},
                                           Wording{"Length", nx("INSERT/H2\nGOTO/10,0,30\n")},
                                           Wording{"LengthOfTheTip", nx("INSERT/G234 H2\nGOTO/10,0,30\n")},
                                           Wording{"Coolant", nx("INSERT/M8\nGOTO/10,0,30\n"), "clean"}),
                         kName);

std::string block_of_nx(const std::string& before, const std::string& within) {
  return "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nMSYS/0,0,0,1,0,0,0,1,0\nGOTO/0,0,30\nEND-OF-PATH\n" + before +
         "TOOL PATH/C,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nMSYS/0,0,0,1,0,0,0,1,0\n" + within +
         "GOTO/10,0,30\nGOTO/20,0,30\nEND-OF-PATH\n";
}

/// The lines of the moves that are checked.
std::string checked_lines(const std::string& text) {
  std::string lines;
  for (const Move& move : read_as(text, "").moves) {
    if (move.not_checked_reason.empty()) lines += std::to_string(move.line) + " ";
  }
  return lines;
}

// A block states its frame, its tool and its axis; nothing else of a file states all of them.
TEST(UnknownWordBefore, IsOverWhereABlockStatesAllAgain) {
  EXPECT_EQ(checked_lines(block_of_nx("", "")), "4 9 10 ");
  EXPECT_EQ(checked_lines(block_of_nx("SHOP_TIME/5\n", "")), "4 11 ") << "where line 10 begins is not known";
  EXPECT_EQ(checked_lines(block_of_nx("", "SHOP_TIME/5\n")), "4 ");
  EXPECT_EQ(checked_lines("UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,30\nSHOP_TIME/5\nGOTO/1,0,30\nCUTTER/10\nLOADTL/1\n"
                          "MULTAX/OFF\nGOTO/2,0,30\nGOTO/3,0,30\nFINI\n"),
            "4 ");
}

// Words that CAM systems write, in the forms of their documents.
INSTANTIATE_TEST_SUITE_P(
    Harmless, UnknownWord,
    ::testing::Values(
        Wording{"Coolant", around("COOLNT/ON\nCOOLNT/FLOOD\nCOOLNT/MIST,HIGH\nCOOLNT/THRU\nCOOLNT/OFF\n"), "clean"},
        Wording{"Spindle",
                around("SPINDL/2000,RPM,CLW\nSPINDL/RPM,-500,CCLW\nSPINDL/70,SFM,CLW,MAXRPM,3000\n"
                       "SPINDL/ORIENT,90\nSPINDL/OFF\n"),
                "clean"},
        Wording{"Stops", around("OPSTOP\nSTOP\nDELAY/2.5\nDELAY/REV,10\nDWELL/2\nREWIND/0\nTMARK/1\n"), "clean"},
        Wording{"Tolerances", around("INTOL/0.01\nOUTTOL/0.02\nTOLER/0.01\nMCHTOL/0.05\nLINTOL/ON\n"), "clean"},
        Wording{"Planes", around("CLRSRF/0,0,1,50\nCLEARP/XYPLAN,60\nHOMEPT/0,0,-100\n"), "clean"},
        Wording{"Post", around("MACHIN/MILL,1\nMACHIN/UNCX01, 1\nSEQNO/10,INCR,5\nLEADER/20\nDISPLY/ON\n"), "clean"},
        Wording{"Loading", around("LOADTL/1,LENGTH,50,OSETNO,3\nLOAD/TOOL,1,ADJUST,2\nTOOLNO/1,10\nSELECT/TOOL,4\n"),
                "clean"},
        Wording{"LoadingOfAName", around("LOAD/TOOL,1,'BALL 10',NEXTTL,5\n"), "clean"},
        Wording{"Feed", around("FEDRAT/500,MMPM\nFEDRAT/INVERS,AUTO\nFEDRAT/INVERS,OFF\nFEDRAT/0.2,MMPR\n"), "clean"},
        Wording{"PathPoint", around("CSI_SET_PATH_PARAM/TOOL_BREAK=ON\nCSI_PATH_TOLERANCE/0.01\n"), "clean"},
        Wording{"TipProgramming", around("TCP/ON\nRTCP/ON\n"), "clean"}),
    kName);

// A word in its place that is not known, or one that belongs to a statement which was joined to it.
INSTANTIATE_TEST_SUITE_P(
    Argument, UnknownWord,
    ::testing::Values(
        Wording{"Coolant", around("COOLNT/ON,BLURB\n")}, Wording{"Spindle", around("SPINDL/1000,CLW,TILT\n")},
        Wording{"Feed", around("FEDRAT/500,MMPF\n")}, Wording{"Loading", around("LOADTL/1,SETOOL,0,0,5\n")},
        Wording{"Tracking", around("LOAD/TOOL,1,TRACKING,2\n")}, Wording{"Unit", around("UNITS/MM,FEET\n")},
        Wording{"CompensationOff", around("CUTCOM/LEFT\nCUTCOM/OFF,BLURB\n")},
        Wording{"PostOff", around("MACHIN/POST,1,OFF\n")}, Wording{"TipProgrammingOff", around("TCP/OFF\n")},
        Wording{"Function", around("PPFUN/CYCLE800\n")}, Wording{"FunctionOfCodes", around("PPFUN/G43,H2\n")},
        Wording{"InsertBehindADollar", around("COOLNT/ON,$\nINSERT/G92 Z0\n")},
        Wording{"InsertBehindALooseDollar", around("MACHIN/POST $\nINSERT G68 R30\n")},
        Wording{"HeadBehindADollar", around("COOLNT/ON $\nHEAD/2\n")},
        Wording{"RetractOnTheLine", around("FEDRAT/500,MMPM RETRCT\n")},
        Wording{"RetractBehindASemicolon", around("COOLNT/ON;RETRCT\n")},
        Wording{"OtherModeOfNx", around("SET/MODE,INCR\n")}, Wording{"CodeOfTheControl", around("PREFUN/52\n")},
        Wording{"CodeOfTheShop", around("AUXFUN/250\n")}, Wording{"Letters", around("LETTER/5,TEXT\n")},
        Wording{"Skip", around("DELETE\n")}, Wording{"SkipOn", around("DELETE/ON\n")}),
    kName);

INSTANTIATE_TEST_SUITE_P(Point, UnknownWord,
                         ::testing::Values(Wording{"Centre", around("$$ BALL CENTRE OUTPUT\n")},
                                           Wording{"CentreInAMessage", around("PPRINT/TOOL REFERENCE POINT: CENTER\n")},
                                           Wording{"Contact", nx("$$ contact data\nGOTO/10,0,30\n")},
                                           Wording{"Centreline", nx("$$ centerline data\nGOTO/10,0,30\n"), "clean"},
                                           Wording{"CentreOfTheTable", around("$$ CENTER DRILL BALL BEARING\n"),
                                                   "clean"}),
                         kName);

const std::string kThrough = "GOTO/-70,0,-10\n", kOut = "GOTO/70,0,-10\n", kOver = "GOTO/-70,0,10\n";

// Between both positions stands a statement that moves nothing and changes no tool; straight the tool goes through the
// box.
INSTANTIATE_TEST_SUITE_P(
    Link, UnknownWord,
    ::testing::Values(Wording{"Nothing", apt(kThrough + kOut), "gouge"},
                      Wording{"SameCutter", apt(kThrough + "CUTTER/10,0,0,0,0,0,60\n" + kOut), "gouge"},
                      Wording{"OtherCutter", apt(kThrough + "CUTTER/10\n" + kOut)},
                      Wording{"OtherCutterOver", apt(kThrough + kOver + "CUTTER/10\nGOTO/70,0,10\n")},
                      Wording{"OtherTool", apt(kThrough + "LOADTL/2\nCUTTER/10\n" + kOut), "clean"},
                      Wording{"OtherCutterLoaded", apt(kThrough + "CUTTER/12\nLOADTL/1\n" + kOut), "not-checked"},
                      Wording{"From", apt(kThrough + "FROM/70,0,-10\n" + kOut)},
                      Wording{"Home", apt(kThrough + "GOHOME\n" + kOut), "clean"},
                      Wording{"NextProgram", apt(kThrough + "FINI\nPARTNO B\n" + kOut), "not-checked"},
                      Wording{"BlockOfNx", nx("GOTO/-70,0,30\n" + kThrough) + nx(""), "not-checked"},
                      Wording{"BlockOfNxAfterARetract", nx("GOTO/10,0,30\n") + nx(""), "clean"},
                      Wording{"SequenceOfCreo",
                              "$$* Pro/CLfile\n$$-> FEATNO / 1\nUNITS / MM\nCUTTER / 10.\nLOADTL / 1\n" + kThrough +
                                  "$$-> FEATNO / 2\n" + kOut + "FINI\n"}),
    kName);

TEST_P(UnknownWord, IsNotTakenForClean) { EXPECT_EQ(outcome_at_box(GetParam().text), GetParam().outcome); }

}  // namespace
}  // namespace gouge::unknown_words_test
