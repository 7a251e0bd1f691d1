// The rows of docs/formats/modal_states.md: which moves of a file are not checked because a statement before or behind
// them contradicts what is in force. Every cell of the table is a case here, under the name the table gives it.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/laws/reading.h"
#include "tests/support/shapes.h"

namespace gouge::modal_states_test {
namespace {

struct ModalCase {
  const char* name;
  std::string text;
  const char* unchecked;  // the lines whose moves are not checked, each once, in order of the file
};

void PrintTo(const ModalCase& modal, std::ostream* out) { *out << modal.text; }

std::string unchecked_lines(const Toolpath& path) {
  std::string lines;
  std::size_t last = 0;
  for (const Move& move : path.moves) {
    if (move.not_checked_reason.empty() || move.line == last) continue;
    last = move.line;
    lines += (lines.empty() ? "" : " ") + std::to_string(last);
  }
  return lines;
}

class ModalStates : public ::testing::TestWithParam<ModalCase> {};

TEST_P(ModalStates, LeaveUncheckedWhatHasMoreThanOneReading) {
  const Toolpath path = read_as(GetParam().text, "");
  std::string reported;
  for (const Move& move : path.moves) {
    if (!move.not_checked_reason.empty())
      reported += std::to_string(move.line) + ": " + std::string(move.not_checked_reason) + "\n";
  }
  EXPECT_EQ(unchecked_lines(path), GetParam().unchecked) << reported;
}

std::string name_of(const ::testing::TestParamInfo<ModalCase>& info) { return info.param.name; }

// Four lines; the first hole is line 6.
std::string apt(const std::string& text) { return "UNITS/MM\nCUTTER/10,0,5,0,0,0,50\nLOADTL/1\nGOTO/0,0,50\n" + text; }

std::string drilled(const std::string& text) {
  return apt("CYCLE/DRILL,FEDTO,7,RAPTO,3,RTRCTO,50\nGOTO/10,0,0\n" + text);
}

std::string solidworks(const std::string& text) {
  return "UNIT/MM\nTRNTYP/WORLD,0,0,0\nCUTTER/10.,0,5.,0,0,0,50.\nLOAD/TOOL,1\nCYCLE/INIT\n"
         "CYCLE/DRILL,FEDTO,7.,MMPM,100.,RAPTO,3.,RTRCTO,50.,DWELL,0\nGOTO/10.,0,0\n" +
         text;
}

std::string creo(const std::string& text) { return "$$* Pro/CLfile\n$$-> FEATNO / 1\nUNITS / MM\nLOADTL / 1\n" + text; }

std::string creo_drilled(const std::string& text) {
  return creo("CYCLE / DRILL, DEPTH, 7, MMPM, 100, CLEAR, 3, RETURN, 50\nGOTO / 10, 0, 0\n" + text);
}

INSTANTIATE_TEST_SUITE_P(
    Cycle, ModalStates,
    ::testing::Values(
        ModalCase{"Ended", drilled("GOTO/20,0,0\nCYCLE/OFF\nGOTO/20,0,60\nLOADTL/2\nGOTO/0,0,50\nFINI\n"), ""},
        ModalCase{"EndedByNomore", drilled("GOTO/20,0,0\nCYCLE/NOMORE\nGOTO/20,0,60\nFINI\n"), ""},
        ModalCase{"FollowedByAnother", drilled("CYCLE/DRILL,FEDTO,7,RAPTO,3\nGOTO/20,0,0\nCYCLE/OFF\nFINI\n"), ""},
        ModalCase{"NewTool", drilled("LOADTL/2\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"NewToolThenOff", drilled("LOADTL/2\nGOTO/20,0,0\nCYCLE/OFF\nGOTO/20,0,60\nGOTO/30,0,60\nFINI\n"),
                  "8 10"},
        ModalCase{"NewToolAfterOff", drilled("CYCLE/OFF\nLOADTL/2\nGOTO/20,0,0\nFINI\n"), ""},
        ModalCase{"NewCutter", drilled("CUTTER/8,0,4,0,0,0,50\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"Rapid", drilled("RAPID\nGOTO/20,0,60\nFINI\n"), "8"},
        ModalCase{"RapidBeforeOff", drilled("RAPID\nCYCLE/OFF\nGOTO/20,0,60\nFINI\n"), ""},
        ModalCase{"Arc", drilled("CIRCLE/15,0,0,0,0,1,5\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"Cutcom", drilled("CUTCOM/LEFT\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"From", drilled("FROM/0,0,50\nGOTO/20,0,0\nFINI\n"), "7 8"},
        ModalCase{"FromBeforeOff", drilled("FROM/0,0,50\nCYCLE/OFF\nGOTO/20,0,60\nGOTO/30,0,60\nFINI\n"), "7 9"},
        ModalCase{"Home", drilled("GOHOME\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"HomeWithAPosition", drilled("GOHOME/0,0,50\nFINI\n"), "7"},
        ModalCase{"Frame", drilled("TRNTYP/WORLD,0,0,0\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"Units", drilled("UNITS/MM\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"Axis", drilled("TLAXIS/0,0,1\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"FeedBetweenHoles", drilled("FEDRAT/100,MMPM\nGOTO/20,0,0\nFINI\n"), "8"},
        ModalCase{"FeedBeforeTheFirstHole",
                  apt("CYCLE/DRILL,FEDTO,7,RAPTO,3\nFEDRAT/100,MMPM\nGOTO/10,0,0\nGOTO/20,0,0\nCYCLE/OFF\nFINI\n"), ""},
        ModalCase{"Step", drilled("RAPID\nGODLTA/10,0,0\nGOTO/20,0,0\nFINI\n"), "8 9"},
        ModalCase{"SecondContradiction", drilled("GOTO/20,0,0\nGOTO/30,0,0\nRAPID\nGOTO/30,0,60\nFINI\n"), "7 8 10"},
        ModalCase{"NeverEnded", drilled("GOTO/20,0,0\nFINI\n"), "7"}, ModalCase{"OneHoleAlone", drilled("FINI\n"), ""},
        ModalCase{
            "BecomesCertainWithAnother",
            drilled("RAPID\nGOTO/20,0,60\nCYCLE/DRILL,FEDTO,7,RAPTO,3\nGOTO/30,0,0\nGOTO/40,0,0\nCYCLE/OFF\nFINI\n"),
            "8 10"},
        ModalCase{"OffOfNothing", apt("GOTO/10,0,0\nGOTO/20,0,0\nCYCLE/OFF\nGOTO/20,0,60\nGOTO/30,0,60\nFINI\n"), ""},
        ModalCase{"OffWithout",
                  drilled("CYCLE/OFF\nRAPID\nGOTO/10,0,60\nGOTO/20,0,0\nCYCLE/OFF\nGOTO/20,0,60\nGOTO/30,0,60\nFINI\n"),
                  "10 12"},
        ModalCase{"OffWithoutAfterRapid", apt("RAPID\nGOTO/10,0,0\nCYCLE/OFF\nGOTO/20,0,60\nFINI\n"), ""},
        ModalCase{"OffAtTheStart", "UNITS/MM\nCYCLE/OFF\nCUTTER/10\nLOADTL/1\nGOTO/0,0,50\nGOTO/1,0,50\nFINI\n", ""},
        ModalCase{"OffTwice", drilled("CYCLE/OFF\nCYCLE/OFF\nGOTO/20,0,60\nFINI\n"), ""},
        ModalCase{"TakenUpWithTheSameTool", drilled("CYCLE/OFF\nCYCLE/ON\nGOTO/20,0,0\nCYCLE/OFF\nFINI\n"), ""},
        ModalCase{"TakenUpWithAnotherTool",
                  drilled("CYCLE/OFF\nLOADTL/2\nGOTO/0,0,50\nCYCLE/ON\nGOTO/20,0,0\nCYCLE/OFF\nGOTO/20,0,60\nFINI\n"),
                  "11 13"},
        ModalCase{"SolidworksTool", solidworks("CUTTER/8.,0,4.,0,0,0,50.\nLOAD/TOOL,2\nGOTO/20.,0,0\nFINI\n"), "10"},
        ModalCase{"SolidworksInit", solidworks("CYCLE/INIT\nGOTO/20.,0,0\nFINI\n"), "9"},
        ModalCase{"SolidworksFeed", solidworks("FEDRAT/100.,MMPM\nGOTO/20.,0,0\nCYCLE/OFF\nFINI\n"), "9"},
        ModalCase{
            "NxArc",
            "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nMSYS/0,0,0,1,0,0,0,1,0\nGOTO/0,0,50\n"
            "CYCLE/DRILL,RAPTO,3,FEDTO,-5\nGOTO/0,0,0\nCIRCLE/5,0,0,0,0,1,5,0.06,0.5,10,0\nGOTO/10,0,0\nCYCLE/OFF\n"
            "END-OF-PATH\n",
            "8"},
        ModalCase{"CampleteFeedBetweenHoles",
                  "CSI_TOOL_PATH/A\nUNITS/MM\nCUTTER/10, 0, 0, 0, 0, 0, 30\nLOADTL/1\nGOTO/0, 0, 30\n"
                  "CYCLE/DRILL, FEDTO, 5, RAPTO, 3, RTRCTO, 30\nGOTO/0, 0, 0\nFEDRAT/100, MMPM\nGOTO/9, 0, "
                  "0\nCYCLE/OFF\nFINI\n",
                  ""},
        ModalCase{
            "CltFeed",
            "UNITS/ MM \nOPFEATSTART/A\nGOTO/ 1,0,50 \nCYCLE/ ON \nCYCLE/ DRILL,G98,5,MMPM,100,2,50 \nGOTO/ 1,0,0 \n"
            "FEDRAT/ MMPM,100 \nGOTO/ 2,0,0 \nCYCLE/ OFF \nFINI \n",
            "8"},
        ModalCase{
            "CltOnAlone",
            "UNITS/ MM \nOPFEATSTART/A\nGOTO/ 1,0,50 \nCYCLE/ DRILL,G98,5,MMPM,100,2,50 \nGOTO/ 1,0,0 \nCYCLE/ OFF \n"
            "CYCLE/ ON \nGOTO/ 2,0,0 \nCYCLE/ OFF \nFINI \n",
            "8"},
        ModalCase{"CatiaOperation",
                  "$$ CATIA APT VERSION 1.0\nUNITS/MM\nLOADTL/1\nGOTO/0,0,50\nCYCLE/DRILL,3,5\nGOTO/0,0,0\n"
                  "$$ OPERATION NAME : A\nGOTO/9,0,0\nCYCLE/OFF\nEND\n",
                  "8"},
        ModalCase{"CreoFeature", creo_drilled("$$-> FEATNO / 2\nGOTO / 20, 0, 0\nCYCLE / OFF\nFINI\n"), "8"},
        ModalCase{"CreoTool", creo_drilled("LOADTL / 2\nGOTO / 20, 0, 0\nCYCLE / OFF\nFINI\n"), "8"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    DescribedArc, ModalStates,
    ::testing::Values(
        ModalCase{"Used", creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nGOTO / 0, 10, 0\nFINI\n"), ""},
        ModalCase{
            "Twice",
            creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nGOTO / 0, 10, 0\n"
                 "FINI\n"),
            "6 8"},
        ModalCase{"LastOfTheFile", creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\n"), "6"},
        ModalCase{"BeforeFini", creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nFINI\n"), "6"},
        ModalCase{"BeforeFrom", creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nFROM / 0, 10, 0\nFINI\n"), "6 7"},
        ModalCase{"BeforeHome", creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nGOHOME\nFINI\n"), "6"},
        ModalCase{"BeforeAFeature",
                  creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\n$$-> FEATNO / 2\nGOTO / 0, 10, 0\nFINI\n"),
                  "6 8"},
        ModalCase{"BeforeACycle",
                  creo("GOTO / 10, 0, 9\nCIRCLE / 0, 0, 9, 0, 0, 1, 10\nCYCLE / DRILL, DEPTH, 7, CLEAR, 3\n"
                       "GOTO / 10, 0, 0\nCYCLE / OFF\nFINI\n"),
                  "6 8"},
        ModalCase{
            "BeforeRapid",
            creo("GOTO / 10, 0, 0\nCIRCLE / 0, 0, 0, 0, 0, 1, 10\nRAPID\nGOTO / 0, 10, 0\nGOTO / 0, 9, 0\nFINI\n"),
            "6 8"},
        ModalCase{"NxBeforeEndOfPath",
                  "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nMSYS/0,0,0,1,0,0,0,1,0\nGOTO/10,0,0\n"
                  "CIRCLE/0,0,0,0,0,1,10,0.06,0.5,10,0\nEND-OF-PATH\n",
                  "5"},
        ModalCase{"HelixTwice", apt("HELIX/1\nHELIX/1\nGOTO/1,0,0\nFINI\n"), "5 7"}),
    name_of);

std::string catia(const std::string& text) { return "$$ CATIA APT VERSION 1.0\nUNITS/MM\nLOADTL/1\n" + text; }

std::string tlon(const std::string& word) { return "TLON,GOFWD/(CIRCLE/0,0,0,10)," + word + ",(LINE/0,0,0,0,10,0)\n"; }

INSTANTIATE_TEST_SUITE_P(
    StartTangent, ModalStates,
    ::testing::Values(
        ModalCase{"Used", catia("GOTO/10,0,0\nINDIRV/0,1,0\nAUTOPS\n" + tlon("ON") + "END\n"), ""},
        ModalCase{"UsedLong", catia("GOTO/10,0,0\nINDIRV/0,-1,0\n" + tlon("ON,2,INTOF") + "GOTO/0,20,0\nEND\n"), ""},
        ModalCase{"BeforeAPosition",
                  catia("GOTO/10,0,0\nINDIRV/0,1,0\nGOTO/10,0,5\nGOTO/10,0,0\n" + tlon("ON") + "END\n"), "5 6 8"},
        ModalCase{"Twice", catia("GOTO/10,0,0\nINDIRV/0,1,0\nINDIRV/0,1,0\n" + tlon("ON") + "END\n"), "5 7"},
        ModalCase{"LastOfTheFile", catia("GOTO/10,0,0\nINDIRV/0,1,0\nEND\n"), "5"},
        ModalCase{"TlonTwice", catia("GOTO/10,0,0\nINDIRV/0,1,0\n" + tlon("ON") + tlon("ON") + "END\n"), "7"},
        ModalCase{"Past", catia("GOTO/10,0,0\nINDIRV/0,1,0\n" + tlon("PAST") + "GOTO/0,20,0\nEND\n"), "6 7"},
        ModalCase{"To", catia("GOTO/10,0,0\nINDIRV/0,1,0\n" + tlon("TO") + "GOTO/0,20,0\nEND\n"), "6 7"},
        ModalCase{"Tanto", catia("GOTO/10,0,0\nINDIRV/0,1,0\n" + tlon("TANTO") + "GOTO/0,20,0\nEND\n"), "6 7"},
        ModalCase{"FirstCrossing", catia("GOTO/10,0,0\nINDIRV/0,1,0\n" + tlon("ON,1,INTOF") + "GOTO/0,20,0\nEND\n"),
                  "6 7"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Axis, ModalStates,
    ::testing::Values(
        ModalCase{"TlonAfterATilt",
                  catia("GOTO/10,0,0,0.6,0,0.8\nINDIRV/0,1,0\n" + tlon("ON") + "GOTO/0,20,0,0,0,1\nEND\n"), "6 7"},
        ModalCase{"TlonUnderMultax",
                  catia("MULTAX\nGOTO/10,0,0,0.6,0,0.8\nINDIRV/0,1,0\n" + tlon("ON") + "GOTO/0,20,0,0,0,1\nEND\n"), ""},
        ModalCase{"PositionAfterATilt", catia("GOTO/10,0,0,0.6,0,0.8\nGOTO/10,0,5\nGOTO/0,20,0,0,0,1\nEND\n"), "5 6"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Cutcom, ModalStates,
    ::testing::Values(
        ModalCase{"CreoAcrossFeatures",
                  creo("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nGOTO / 0, 0, 9\nCUTCOM / LEFT\nGOTO / 0, 0, 0\n"
                       "$$-> FEATNO / 2\nGOTO / 9, 0, 0\nCUTCOM / OFF\nGOTO / 9, 9, 0\nGOTO / 9, 0, 9\nFINI\n"),
                  "10 12"},
        ModalCase{"CreoFeatureThatSaysCentre",
                  creo("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nGOTO / 0, 0, 9\nCUTCOM / LEFT\nGOTO / 0, 0, 0\n"
                       "$$-> FEATNO / 2\n$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nGOTO / 9, 0, 0\nFINI\n"),
                  ""},
        ModalCase{"CreoEndedInItsFeature",
                  creo("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nGOTO / 0, 0, 9\nCUTCOM / LEFT\nGOTO / 0, 0, 0\n"
                       "CUTCOM / OFF\n$$-> FEATNO / 2\nGOTO / 9, 0, 0\nFINI\n"),
                  ""},
        ModalCase{"NeverEnded", apt("CUTCOM/LEFT\nGOTO/0,0,0\nLOADTL/2\nGOTO/9,0,0\nFINI\n"), "6 8"},
        ModalCase{"OffOfNothing", apt("GOTO/0,0,0\nGOTO/9,0,0\nCUTCOM/OFF\nGOTO/9,9,0\nGOTO/9,0,9\nFINI\n"), ""},
        ModalCase{"OffWithout",
                  apt("CUTCOM/LEFT\nGOTO/-9,0,0\nCUTCOM/OFF\nLOADTL/2\nGOTO/0,0,0\nGOTO/9,0,0\nCUTCOM/OFF\n"
                      "GOTO/9,9,0\nGOTO/9,0,9\nFINI\n"),
                  "6 9 10 12"},
        ModalCase{"OffWithoutAfterATool", apt("LOADTL/2\nCUTCOM/OFF\nGOTO/9,9,0\nGOTO/9,0,9\nFINI\n"), ""},
        ModalCase{"OffTwice", apt("CUTCOM/LEFT\nGOTO/0,0,0\nCUTCOM/OFF\nCUTCOM/OFF\nGOTO/9,9,0\nGOTO/9,0,9\nFINI\n"),
                  "6 9"},
        ModalCase{"OffWithoutBehindAnArc",
                  apt("CUTCOM/LEFT\nGOTO/-30,-10,0\nCUTCOM/OFF\nLOADTL/3\nGOTO/-20,-10,0\nGOTO/0,-10,0\n"
                      "CIRCLE/0,0,0,0,0,1,10\nGOTO/10,0,0\nGOTO/10,20,0\nGOTO/0,-10,0\n"
                      "CIRCLE/0,0,0,0,0,1,10\nGOTO/10,0,0\nGOTO/10,20,0\nCUTCOM/OFF\nLOADTL/2\nGOTO/-20,-10,0\n"
                      "GOTO/0,-10,0\nCIRCLE/0,0,0,0,0,1,10\nGOTO/10,0,0\nGOTO/10,20,0\nFINI\n"),
                  "6 9 10 12 13 14 16 17"},
        ModalCase{
            "CreoOffWithoutOnCentre",
            creo("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nGOTO / 0, 0, 9\nCUTCOM / OFF\nGOTO / 0, 0, 0\nFINI\n"),
            ""},
        ModalCase{"AdjustOffOfNothing", apt("GOTO/0,0,0\nCUTCOM/ADJUST,OFF\nGOTO/9,0,0\nGOTO/9,0,9\nFINI\n"), ""},
        ModalCase{"LengthOfNoRegister", apt("CUTCOM/LENGTH,-10\nGOTO/0,0,0\nFINI\n"), "6"},
        ModalCase{"AdjustWithASide", apt("CUTCOM/ADJUST,OFF,LEFT\nCUTCOM/ADJUST,OFF\nGOTO/0,0,0\nFINI\n"), "7"}),
    name_of);

const std::string kShifted = "MSYS/0,0,30,1,0,0,0,1,0\n";

std::string nx(const std::string& block, const std::string& text) { return block + "TLDATA/MILL,10,0,50,0,0\n" + text; }

INSTANTIATE_TEST_SUITE_P(
    Block, ModalStates,
    ::testing::Values(ModalCase{"EachWithItsFrame",
                                nx("TOOL PATH/A,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx("TOOL PATH/B,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n"),
                                ""},
                      ModalCase{"MsysBetween",
                                nx("TOOL PATH/A,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx(kShifted + "TOOL PATH/B,TOOL,B\n", "GOTO/0,0,0\nGOTO/1,0,0\nEND-OF-PATH\n"),
                                "9 10"},
                      ModalCase{"MsysBetweenAndWithin",
                                nx("TOOL PATH/A,TOOL,B\n", "GOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx(kShifted + "TOOL PATH/B,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n"),
                                "3"},
                      ModalCase{"MsysMissing",
                                nx("TOOL PATH/A,TOOL,B\n", "GOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx("TOOL PATH/B,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n"),
                                "3"},
                      ModalCase{"NoneHasOne",
                                nx("TOOL PATH/A,TOOL,B\n", "GOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx("TOOL PATH/B,TOOL,B\n", "GOTO/0,0,0\nEND-OF-PATH\n"),
                                ""},
                      ModalCase{"PositionBetween",
                                nx("TOOL PATH/A,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\nGOTO/0,0,0\n") +
                                    nx("TOOL PATH/B,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n"),
                                "6"},
                      ModalCase{"NoToolPath",
                                nx("", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx("TOOL PATH/B,TOOL,B\n", kShifted + "GOTO/0,0,0\nEND-OF-PATH\n"),
                                "3"},
                      ModalCase{"OpenCycleInANewBlock",
                                nx("TOOL PATH/A,TOOL,B\n",
                                   kShifted + "CYCLE/DRILL,RAPTO,3,FEDTO,-5\nGOTO/0,0,0\nEND-OF-PATH\n") +
                                    nx("TOOL PATH/B,TOOL,B\n", kShifted + "GOTO/0,0,0\nCYCLE/OFF\nEND-OF-PATH\n"),
                                "10"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Spline, ModalStates,
    ::testing::Values(ModalCase{"OffAndOn", apt("SPLINE/ON,OFF\nGOTO/1,0,0\nSPLINE/OFF\nGOTO/2,0,0\nFINI\n"), "6 8"},
                      ModalCase{"OffOfNothing", apt("GOTO/1,0,0\nSPLINE/OFF\nGOTO/2,0,0\nGOTO/3,0,0\nFINI\n"), ""},
                      ModalCase{"NeverEnded", apt("SPLINE/ON\nGOTO/1,0,0\nLOADTL/2\nGOTO/2,0,0\nFINI\n"), "6 8"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Shift, ModalStates,
    ::testing::Values(
        ModalCase{"Undone", apt("TRANS/0,0,5\nGOTO/1,0,0\nTRANS/0,0,0\nGOTO/2,0,0\nGOTO/3,0,0\nFINI\n"), "6 8"},
        ModalCase{"ZerosOfNothing", apt("GOTO/1,0,0\nTRANS/0,0,0\nGOTO/2,0,0\nGOTO/3,0,0\nFINI\n"), ""},
        ModalCase{"OriginZerosOfNothing", apt("GOTO/1,0,0\nORIGIN/0,0,0\nGOTO/2,0,0\nFINI\n"), ""},
        ModalCase{"ZerosAtTheStart", "UNITS/MM\nTRANS/0,0,0\nCUTTER/10\nLOADTL/1\nGOTO/2,0,0\nFINI\n", ""},
        ModalCase{"NeverUndone", apt("TRANS/0,0,5\nGOTO/1,0,0\nLOADTL/2\nGOTO/2,0,0\nFINI\n"), "6 8"}),
    name_of);

const std::string kRows = "$$     1.0   0.0   0.0   0.0\n$$     0.0   1.0   0.0   0.0\n$$     0.0   0.0   1.0   5.0\n";

INSTANTIATE_TEST_SUITE_P(
    BlockSkip, ModalStates,
    ::testing::Values(
        ModalCase{"Ended", apt("GOTO/1,0,0\nOPSKIP/ON\nGOTO/2,0,9\nOPSKIP/OFF\nGOTO/3,0,0\nGOTO/4,0,0\nFINI\n"), "7 9"},
        ModalCase{"NeverEnded", apt("GOTO/1,0,0\nOPSKIP/ON\nGOTO/2,0,9\nGOTO/3,0,0\nFINI\n"), "7 8"},
        ModalCase{"OffAtTheStart", apt("OPSKIP/OFF\nGOTO/1,0,0\nFINI\n"), ""},
        ModalCase{"OffBehindATool", "UNITS/MM\nLOADTL/1\nOPSKIP/OFF\nGOTO/1,0,0\nGOTO/2,0,0\nFINI\n", ""},
        ModalCase{"OffOfNothing", apt("GOTO/1,0,0\nOPSKIP/OFF\nGOTO/2,0,0\nGOTO/3,0,0\nFINI\n"), ""},
        ModalCase{"WithAFeedAlone", apt("OPSKIP/ON\nFEDRAT/100,MMPM\nOPSKIP/OFF\nGOTO/1,0,0\nFINI\n"), ""},
        ModalCase{"WithATool", apt("OPSKIP/ON\nLOADTL/2\nOPSKIP/OFF\nGOTO/1,0,0\nGOTO/2,0,0\nFINI\n"), "8 9"},
        ModalCase{"WithAnAxis", apt("OPSKIP/ON\nTLAXIS/.6,0,.8\nOPSKIP/OFF\nGOTO/1,0,0\nGOTO/2,0,0\nFINI\n"), "8 9"},
        ModalCase{"OfAnotherWord", apt("OPSKIP/2\nGOTO/1,0,0\nOPSKIP/OFF\nGOTO/2,0,0\nFINI\n"), "6 8"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Program, ModalStates,
    ::testing::Values(ModalCase{"AfterTheEnd",
                                apt("FINI\nPARTNO B\nUNITS/MM\nLOADTL/2\nTLAXIS/0,0,1\nGOTO/1,0,0\nGOTO/2,0,0\nFINI\n"),
                                "10 11"},
                      ModalCase{"EndAndFini", apt("GOTO/1,0,0\nEND\nFINI\n"), ""}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Matrix, ModalStates,
    ::testing::Values(ModalCase{"Whole", "$$ CATIA APT VERSION 1.0\n$$*CATIA0\n$$ A\n" + kRows + "GOTO/0,0,0\nEND\n",
                                ""},
                      ModalCase{"RowsAlone", "$$ CATIA APT VERSION 1.0\n$$ A\n" + kRows + "GOTO/0,0,0\nEND\n", "6"},
                      ModalCase{"RowsAloneThenWhole",
                                "$$ CATIA APT VERSION 1.0\n$$ A\n" + kRows + "GOTO/0,0,0\n$$*CATIA0\n$$ A\n" + kRows +
                                    "GOTO/0,0,0\nEND\n",
                                "6"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Mode, ModalStates,
                         ::testing::Values(ModalCase{"Both", apt("MODE/TURN,MILL\nGOTO/1,0,0\nFINI\n"), "6"},
                                           ModalCase{"Undone", apt("MODE/TURN\nMODE/MILL\nGOTO/1,0,0\nFINI\n"), ""}),
                         name_of);

std::string cycle_of(const std::string& words) { return apt("CYCLE/" + words + "\nGOTO/10,0,0\nCYCLE/OFF\nFINI\n"); }

std::string clt_arc(const std::string& words) {
  return "UNITS/ MM \nOPFEATSTART/A\nGOTO/ 1,0,0 \nCIRCLE/ 0,0,0,0,0,1,1," + words + " \nGOTO/ 0,1,0 \nFINI \n";
}

INSTANTIATE_TEST_SUITE_P(
    OneStatement, ModalStates,
    ::testing::Values(
        ModalCase{"Cycle", cycle_of("DRILL,FEDTO,15,RAPTO,2,RTRCTO,50"), ""},
        ModalCase{"TwoDepths", cycle_of("DRILL,FEDTO,1,FEDTO,15,RAPTO,2,RTRCTO,50"), "6"},
        ModalCase{"DepthOfTwoKinds", cycle_of("DRILL,DEPTH,15,FEDTO,1,RAPTO,2,RTRCTO,50"), "6"},
        ModalCase{"TwoClearances", cycle_of("DRILL,FEDTO,15,RAPTO,2,CLEAR,9"), "6"},
        ModalCase{"TwoClearancesBelowTheRetract", cycle_of("DRILL,FEDTO,15,RAPTO,2,CLEAR,9,RTRCTO,50"), ""},
        ModalCase{"EqualClearances", cycle_of("DRILL,FEDTO,15,RAPTO,2,CLEAR,2,RTRCTO,50"), ""},
        ModalCase{"TwoRetracts", cycle_of("DRILL,FEDTO,15,RAPTO,2,RTRCTO,50,RETURN,5"), "6"},
        ModalCase{"HeightWithTwoNumbers", cycle_of("DRILL,FEDTO,15,RAPTO,2,50"), "6"},
        ModalCase{"RetractShort", cycle_of("DRILL,FEDTO,15,RAPTO,2,RTRCT,50"), "6"},
        ModalCase{"RetractChanged", cycle_of("DRILL,FEDTO,15,RAPTO,2,RTQCTO,50"), "6"},
        ModalCase{"RetractLong", cycle_of("DRILL,FEDTO,15,RAPTO,2,RTRCTOO,50"), "6"},
        ModalCase{"RetractRunIn", cycle_of("DRILL,FEDTO,15,RAPTO,2,RTRCTO50"), "6"},
        ModalCase{"RetractRunOn", cycle_of("DRILL,FEDTO,15,RAPTO,2RTRCTO,50"), "6"},
        ModalCase{"OtherWords", cycle_of("DEEP,FEDTO,15,RAPTO,2,STEP,1,DWELL,1,RTRCTO,50"), ""},
        ModalCase{"OnAndOff", cycle_of("DRILL,FEDTO,15,RAPTO,2,OFF"), "6"},
        ModalCase{"OffAndOn", cycle_of("OFF,DRILL,FEDTO,15,RAPTO,2"), "6"},
        ModalCase{"CatiaDepthOfTwoKinds",
                  catia("GOTO/0,0,9\nCYCLE/DRILL,3,5,DEPTH,9,CLEAR,1\nGOTO/0,0,0\nCYCLE/OFF\nEND\n"), "6"},
        ModalCase{"CltClockwise", clt_arc("CLOCKWISE"), ""},
        ModalCase{"CltBothSenses", clt_arc("COUNTERCLOCKWISE,CLOCKWISE"), "5"},
        ModalCase{"CltBothLevels",
                  "UNITS/ MM \nOPFEATSTART/A\nGOTO/ 1,0,50 \nCYCLE/ DRILL,G98,5,G99,9,MMPM,100,2,50 \n"
                  "GOTO/ 1,0,0 \nCYCLE/ OFF \nFINI \n",
                  "5"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Unit, ModalStates,
    ::testing::Values(ModalCase{"Late", "GOTO/1,1,1\nGOTO/2,2,2\nUNITS/INCHES\nGOTO/3,3,3\nFINI\n", "1 2"},
                      ModalCase{"LateAndTheSame", "GOTO/1,1,1\nGOTO/2,2,2\nUNITS/MM\nGOTO/3,3,3\nFINI\n", ""},
                      ModalCase{"Changed", "UNITS/MM\nGOTO/1,1,1\nUNITS/INCHES\nGOTO/3,3,3\nFINI\n", ""}),
    name_of);

TEST(Units, TwoInOneStatementAreRefused) {
  for (const char* units : {"UNITS/MM,INCHES\n", "UNITS/INCHES,MM\n", "UNIT/IN,MM\n"}) {
    const ReadOutcome outcome = read_toolpath("real.apt", units + std::string("GOTO/0,0,0\nFINI\n"));
    ASSERT_EQ(outcome.errors.size(), 1U) << units;
    EXPECT_EQ(outcome.errors.front().code, "path-statement");
  }
  EXPECT_EQ(read_as("UNITS/MM,MM\nGOTO/0,0,0\nFINI\n", "").moves.size(), 1U);
}

}  // namespace
}  // namespace gouge::modal_states_test
