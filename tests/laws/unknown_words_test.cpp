// Words that no reader here knows inside statements that are known, and ways between positions that no statement
// defines: the part would be cut if they meant what other post-processors mean by them, so none is clean.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "postproc/cldata/reading/read_toolpath.h"
#include "tests/laws/reading.h"

namespace gouge {
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
                      Wording{"ToolnoOfAnotherMill", apt("TOOLNO/1,MILL,1,0,40\nGOTO/0,0,30\n")},
                      Wording{"Compensation", around("TLCOMP/LEFT\n")}, Wording{"Steps", around("INCREM\n")},
                      Wording{"Tilt", around("HEADTILT/30\n")}, Wording{"Axis", around("BAXIS/45\n")},
                      Wording{"ShiftOfZ", around("ZSHIFT/5\n")}, Wording{"Feature", around("FEATURE/12\n"), "clean"}),
    kName);

INSTANTIATE_TEST_SUITE_P(Machine, UnknownWord,
                         ::testing::Values(Wording{"CallOfOkuma", nx("INSERT/CALL O1000\nGOTO/10,0,30\n")},
                                           Wording{"CallOfALetter", nx("INSERT/CALL L1\nGOTO/10,0,30\n")},
                                           Wording{"CallInASentence",
                                                   nx("INSERT/CALL THE OPERATOR AT ONCE\nGOTO/10,0,30\n"), "clean"},
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

const std::string kThrough = "GOTO/-70,0,-10\n", kOut = "GOTO/70,0,-10\n", kOver = "GOTO/-70,0,10\n";

// Between both positions stands a statement that moves nothing and changes no tool; straight the tool goes through the
// box.
INSTANTIATE_TEST_SUITE_P(
    Link, UnknownWord,
    ::testing::Values(Wording{"Nothing", apt(kThrough + kOut), "gouge"},
                      Wording{"SameCutter", apt(kThrough + "CUTTER/10,0,0,0,0,0,60\n" + kOut), "gouge"},
                      Wording{"OtherCutter", apt(kThrough + "CUTTER/10\n" + kOut)},
                      Wording{"OtherCutterOver", apt(kThrough + kOver + "CUTTER/10\nGOTO/70,0,10\n"), "clean"},
                      Wording{"OtherTool", apt(kThrough + "LOADTL/2\nCUTTER/10\n" + kOut), "clean"},
                      Wording{"OtherCutterLoaded", apt(kThrough + "CUTTER/12\nLOADTL/1\n" + kOut), "clean"},
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
}  // namespace gouge
