// Statements with more than one reading: what is checked of each of them, and what is left unchecked.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "lib/path/run_kind.h"
#include "postproc/cldata/parsing/arc_statement.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::further_readings_test {
namespace {

std::string apt(const std::string& text) { return "UNITS/MM\nCUTTER/10\nLOADTL/1\n" + text; }

std::string catia(const std::string& text) {
  return "$$ CATIA APT VERSION 1.0\nMULTAX/ON\nCUTTER/10\nLOADTL/1\n" + text + "END\n";
}

std::string nx(const std::string& text) {
  return "TOOL PATH/A,TOOL,T\nTLDATA/MILL,10.,0.,50.,0.,0.\nFEDRAT/MMPM,100.\n" + text + "END-OF-PATH\n";
}

std::size_t unchecked(const Toolpath& path) {
  return static_cast<std::size_t>(
      std::ranges::count_if(path.moves, [](const Move& move) { return !move.not_checked_reason.empty(); }));
}

std::size_t covered(const Toolpath& path) {
  return static_cast<std::size_t>(std::ranges::count_if(path.moves, &Move::is_covered));
}

TEST(LockedAxis, OfCatiaIsThatOfTheLastPositionWithFiveAxes) {
  const Toolpath path = path_of(catia("GOTO/0,0,50,0.6,0,0.8\nMULTAX/OFF\nGOTO/0,0,5\nGOTO/9,0,5\n"));
  ASSERT_EQ(path.moves.size(), 3U);
  EXPECT_EQ(unchecked(path), 0U);
  expect_vector(path.moves[2].end.axis, 0.6, 0, 0.8);
}

TEST(LockedAxis, OfCatiaEndsWithMultaxOn) {
  const Toolpath path = path_of(
      catia("FROM/0,0,50,0.6,0,0.8\nMULTAX/OFF\nGOTO/0,0,5\nMULTAX/ON\nGOTO/9,0,5,0,0,1\nMULTAX/OFF\nGOTO/9,0,4\n"));
  ASSERT_EQ(path.moves.size(), 4U);
  expect_vector(path.moves[1].end.axis, 0.6, 0, 0.8);
  expect_vector(path.moves[3].end.axis, 0, 0, 1);
}

TEST(LockedAxis, IsNotKnownBehindAnotherFrame) {
  const std::string turned = "$$*CATIA0\n$$ A\n$$ 0. -1. 0. 0.\n$$ 1. 0. 0. 0.\n$$ 0. 0. 1. 0.\n";
  const std::string plain = "$$*CATIA0\n$$ A\n$$ 1. 0. 0. 0.\n$$ 0. 1. 0. 0.\n$$ 0. 0. 1. 0.\n";
  const Toolpath path =
      path_of(catia(plain + "GOTO/0,0,50,0.6,0,0.8\nMULTAX/OFF\nGOTO/0,0,5\n" + turned + "GOTO/9,0,5\n"));
  ASSERT_EQ(path.moves.size(), 3U);
  EXPECT_TRUE(path.moves[1].not_checked_reason.empty());
  EXPECT_FALSE(path.moves[2].not_checked_reason.empty());
}

TEST(LockedAxis, IsNotKnownInAFileOfNoDialect) {
  const Toolpath path = path_of(apt("MULTAX/ON\nGOTO/0,0,50,0.6,0,0.8\nMULTAX/OFF\nGOTO/0,0,5\nFINI\n"));
  EXPECT_EQ(unchecked(path), 1U);
  const Toolpath upright = path_of(apt("MULTAX/ON\nGOTO/0,0,50,0,0,1\nMULTAX/OFF\nGOTO/0,0,5\nFINI\n"));
  EXPECT_EQ(unchecked(upright), 0U);
}

TEST(Nurbs, KeepsTheAxisOfItsControlPoints) {
  const std::string begin =
      "GOTO/0.,0.,9.\nNURBS/\nKNOT/1.\nCNTRL/1.,0.,9.,0.6,0.,0.8\nCNTRL/2.,0.,9.\nCNTRL/3.,0.,9.\n";
  const Toolpath path = path_of(nx(begin + "GOTO/4.,0.,9.\n"));
  ASSERT_EQ(path.moves.size(), 3U);
  EXPECT_FALSE(path.moves[1].not_checked_reason.empty());  // its axis turns
  expect_vector(path.moves[2].end.axis, 0.6, 0, 0.8);
}

TEST(Nurbs, OfAControlIsNotCheckedToItsEnd) {
  const std::string curve = "BEGIN NURBS_SIEMENS(D=3,F=100);\nN0,XT=0.,YT=0.,ZT=9.,$\nXH=0.,YH=0.,ZH=10.;\n";
  const Toolpath ended =
      path_of(catia("GOTO/0,0,9,0,0,1\n" + curve + "END NURBS;\nGOTO/1,0,9,0,0,1\nGOTO/2,0,9,0,0,1\n"));
  ASSERT_EQ(ended.moves.size(), 4U);
  EXPECT_EQ(unchecked(ended), 2U);
  const Toolpath open = path_of(catia("GOTO/0,0,9,0,0,1\n" + curve + "GOTO/1,0,9,0,0,1\nGOTO/2,0,9,0,0,1\n"));
  EXPECT_EQ(unchecked(open), 3U);
}

TEST(Frame, OfScaledAxesIsNotChecked) {
  const auto unchecked_in = [](const std::string& x) {
    return unchecked(path_of(nx("MSYS/0.,0.,0.," + x + ",0.,1.0000000,0.\nGOTO/0.,0.,9.\n")));
  };
  EXPECT_EQ(unchecked_in("1.0000000,0.,0."), 0U);
  EXPECT_EQ(unchecked_in("1.0000100,0.,0."), 1U);
  EXPECT_EQ(unchecked_in("1.0000000,0.0001000,0."), 1U);
}

TEST(Arc, HasARadiusWithinTheRoundingOfItsNumbers) {
  const auto unchecked_at = [](const std::string& radius) {
    return unchecked(path_of(nx("GOTO/0.0000,0.0000,9.0000\nCIRCLE/5.0000,0.0000,9.0000,0.,0.,1.," + radius +
                                ",0.06,0.5,10.,0.\nGOTO/10.0000,0.0000,9.0000\n")));
  };
  EXPECT_EQ(unchecked_at("5.0001"), 0U);
  EXPECT_EQ(unchecked_at("5.0030"), 1U);
}

TEST(Arc, OfNoSenseIsCoveredByItsCircle) {
  const Toolpath path = path_of(apt("GOTO/0,0,9\nCIRCLE/5,0,9,0,0,1,5\nGOTO/10,0,9\nFINI\n"));
  ASSERT_EQ(path.moves.size(), 2U);
  EXPECT_TRUE(path.moves[1].is_covered());
  EXPECT_NEAR(path.arcs[path.moves[1].curve].sweep_rad, 3 * std::numbers::pi, 1e-12);
}

TEST(Arc, RisesByTheArcslpBeforeIt) {
  const auto is_slope_wrong = [](const std::string& before) {
    const Toolpath path = path_of(apt("GOTO/0,0,9\n" + before + "CIRCLE/5,0,9,0,0,1,5\nGOTO/10,0,9\nFINI\n"));
    return path.moves.back().not_checked_reason == ArcProblems::kSlope;
  };
  EXPECT_TRUE(is_slope_wrong("ARCSLP/5\n"));
  EXPECT_TRUE(is_slope_wrong("ARCSLP/5\nGOTO/0,9,9\nGOTO/0,0,9\n"));  // the next arc, not the next motion
  EXPECT_TRUE(is_slope_wrong("ARCSLP/5,1\n"));
  EXPECT_TRUE(is_slope_wrong("OPSKIP/ON\nARCSLP/5\nOPSKIP/OFF\n"));
  EXPECT_FALSE(is_slope_wrong("ARCSLP/0\n"));
  EXPECT_FALSE(is_slope_wrong("ARCSLP/5\nARCSLP/OFF\n"));
  EXPECT_FALSE(is_slope_wrong("ARCSLP/ON\n"));
}

TEST(Arc, OfPartOfATurnAndTimesIsCheckedBothWays) {
  const Toolpath path = path_of(
      nx("GOTO/0.,0.,9.\nCIRCLE/5.,0.,9.,0.,0.,-1.,5.,0.06,0.5,10.,0.,TIMES,2\nGOTO/10.,0.,1.\nGOTO/20.,0.,1.\n"));
  ASSERT_EQ(path.moves.size(), 5U);
  EXPECT_EQ(covered(path), 3U);
  EXPECT_NEAR(path.arcs[path.moves[1].curve].sweep_rad, -3 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(path.arcs[path.moves[3].curve].sweep_rad, -5 * std::numbers::pi, 1e-9);
  EXPECT_TRUE(path.moves[4].has_start);
  EXPECT_TRUE(path.moves[4].not_checked_reason.empty());
}

TEST(Cutcom, IsCoveredByAWideToolAcrossTheAxisAlone) {
  const Toolpath path = path_of(apt("GOTO/0,0,9\nCUTCOM/LEFT\nGOTO/9,0,9\nCUTCOM/OFF\nGOTO/9,9,9\nGOTO/0,9,9\nFINI\n"));
  ASSERT_EQ(path.moves.size(), 4U);
  EXPECT_EQ(std::ranges::count_if(path.moves, &Move::needs_wide_tool), 2);
  const Toolpath other = path_of(apt("GOTO/0,0,9\nCUTCOM/LEFT,YZPLAN\nGOTO/9,0,9\nCUTCOM/OFF\nFINI\n"));
  EXPECT_EQ(covered(other), 0U);
}

TEST(Retract, GoesToTheClearancePlaneThatTheFileStates) {
  const Toolpath path = path_of(apt("CLEARP/XYPLAN,50\nGOTO/0,0,9\nRETRCT\nGOTO/9,0,9\nGOTO/9,0,1\nFINI\n"));
  ASSERT_EQ(path.moves.size(), 7U);
  expect_vector(path.moves[1].end.tip, 0, 0, 50);
  EXPECT_EQ(covered(path), 5U);
  EXPECT_TRUE(path.moves[6].not_checked_reason.empty());
}

TEST(Copy, RepeatsTheMovesOfItsIndex) {
  const Toolpath path =
      path_of(apt("GOTO/0,0,9\nINDEX/1\nGOTO/1,0,9\nGOTO/2,0,9\nINDEX/1,NOMORE\nCOPY/1,TRANSL,0,10,0,2\nFINI\n"));
  ASSERT_EQ(path.moves.size(), 7U);
  EXPECT_EQ(unchecked(path), 0U);
  expect_vector(path.moves[6].end.tip, 2, 20, 9);
}

TEST(Copy, OfAStepThatContinuesFromElsewhereIsNotRead) {
  const Toolpath steps = path_of(apt("GOTO/0,0,9\nINDEX/1\nGODLTA/0,0,-.1\nCOPY/1,SAME,20\nGOTO/0,0,50\nFINI\n"));
  EXPECT_GT(unchecked(steps), 0U);
  const Toolpath placed =
      path_of(apt("GOTO/0,0,9\nINDEX/1\nGOTO/1,0,9\nGODLTA/0,0,-.1\nCOPY/1,SAME,2\nGOTO/0,0,50\nFINI\n"));
  EXPECT_EQ(unchecked(placed), 0U);
  expect_vector(placed.moves[6].end.tip, 1, 0, 8.9);
}

TEST(Tool, NumberBehindALoadingMayBeReadyOnly) {
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9\nTOOLNO/4\nGOTO/9,0,9\nLOADTL/4\nGOTO/0,0,9\nFINI\n"))), 2U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9\nCUTTER/6\nGOTO/9,0,9\nLOADTL/4\nGOTO/0,0,9\nFINI\n"))), 1U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9\nCUTTER/6\nTOOLNO/4\nLOADTL/4\nGOTO/9,0,9\nFINI\n"))), 0U);
}

/// The tools of a path: "1=L" for number and name, with further names behind it.
std::string tools_of(const Toolpath& path) {
  std::string all;
  for (const PathTool& tool : path.tools) {
    all += (all.empty() ? "" : " ") + (tool.number ? std::to_string(*tool.number) : "") + "=" + tool.name;
    for (const std::string& name : tool.other_names) all += "," + name;
  }
  return all;
}

TEST(Tool, HasTheNameThatStandsBeforeItsNumber) {
  const std::string move = "GOTO/0,0,9\n";
  const auto nx_tools = [&](const std::string& text) {
    return tools_of(path_of("TOOL PATH/A,TOOL,L\n" + text + "END-OF-PATH\n"));
  };
  EXPECT_EQ(nx_tools("LOAD/TOOL,1\n" + move), "1=L");
  EXPECT_EQ(nx_tools(move + "LOAD/TOOL,1\n" + move), "=L 1=L");
  EXPECT_EQ(nx_tools("LOAD/TOOL,1\n" + move + "LOAD/TOOL,2\n" + move), "1=L 2=");
  EXPECT_EQ(nx_tools("LOAD/TOOL,1\n" + move + "END-OF-PATH\nTOOL PATH/B,TOOL,M\nLOAD/TOOL,1\n" + move), "1=L 1=M");
  const auto tools = [&](const std::string& text) { return tools_of(path_of("UNITS/MM\n" + text + "FINI\n")); };
  EXPECT_EQ(tools("TPRINT/L\nLOADTL/1\n" + move), "1=L");
  EXPECT_EQ(tools("TPRINT/L\nLOADTL/1\nLOADTL/2\n" + move), "2=");
  EXPECT_EQ(tools("LOADTL/1\nTPRINT/L\n" + move + "LOADTL/2\n" + move), "1=L 2=");
  EXPECT_EQ(tools("LOADTL/1\nTPRINT/L\n" + move + "CUTTER/6\nLOADTL/2\n" + move), "1=L 2=") << "the name of T1";
  EXPECT_EQ(tools("LOADTL/1\n" + move + "TPRINT/L\nLOADTL/1\n" + move + "TPRINT/M\n" + move), "1=,L,M");
  EXPECT_EQ(tools("LOAD/TOOL,1,'L, long',ADJUST,2\n" + move), "1=L, long");
  EXPECT_EQ(tools("TPRINT/M\nLOADTL/1,'L'\n" + move + "LOADTL/2\n" + move), "1=L 2=");
}

TEST(Tool, OfAnotherNameHasNoCutterOfItsNumber) {
  const std::string block = "LOAD/TOOL,1\nGOTO/0,0,9,0,0,1\nEND-OF-PATH\n";
  const Toolpath path = path_of("TOOL PATH/A,TOOL,L\nTLDATA/MILL,10.,0.,50.,0.,0.\n" + block + "TOOL PATH/B,TOOL,M\n" +
                                block + "TOOL PATH/C,TOOL,L\n" + block);
  ASSERT_EQ(path.tools.size(), 2U);
  EXPECT_TRUE(path.tools[0].cutter.has_value());
  EXPECT_FALSE(path.tools[1].cutter.has_value());
}

TEST(Numbers, WithABlankWithinNameNoTool) {
  EXPECT_EQ(unchecked(path_of("UNITS/MM\nCUTTER/2 0\nLOADTL/1\nGOTO/0,0,9\nFINI\n")), 1U);
  EXPECT_EQ(unchecked(path_of("UNITS/MM\nCUTTER/20\nTOOLNO/1 2\nGOTO/0,0,9\nFINI\n")), 1U);
}

TEST(Numbers, OfPositionAxisAndNormalAreNoThreePositions) {
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9,0.6,0,0.8,0,0,1\nFINI\n"))), 1U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9,5,0,9,9,0,9\nFINI\n"))), 0U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9,0,0,1\nGOTO/0,0,9,5,0,9,9,0,9\nFINI\n"))), 1U);
}

TEST(LastLine, WithoutAnEndIsWholeWhereItsDecimalsShowIt) {
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0.000,0.000,9.000\nGOTO/9.000,0.000,8.500"))), 0U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0.000,0.000,9.000\nGOTO/9.000,0.000,8.5"))), 1U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9\nGOTO/9,0,-1"))), 1U);
  EXPECT_EQ(unchecked(path_of(apt("GOTO/0,0,9\nGOTO/9,0,-1\n"))), 0U);
}

TEST(Cycle, WhosePositionMayBeEitherEndOfTheHoleIsAColumn) {
  const std::string begin = "MODE/MILL\nUNITS/MM\nMULTAX/OFF\nCUTTER/8\nLOADTL/1\nRAPID\nGOTO/0,0,60\n";
  const Toolpath path = path_of(begin +
                                "CYCLE/DRILL, 20, MMPM, 100, 3, RAPTO, 1\nGOTO/0,0,0\nGOTO/30,0,0\nCYCLE/OFF\n"
                                "RAPID\nGOTO/30,0,60\nEND\n");
  double lowest = 0;
  for (const Move& move : path.moves) lowest = std::min(lowest, move.end.tip.z());
  EXPECT_NEAR(lowest, -20, 1e-9);
  EXPECT_EQ(covered(path), unchecked(path));
  EXPECT_EQ(covered(path) + 1, path.moves.size());
}

std::vector<bool> rapids_of(const Toolpath& path) {
  std::vector<bool> rapids;
  for (const Move& move : path.moves) rapids.push_back(runs_rapid(move));
  return rapids;
}

using Rapids = std::vector<bool>;

TEST(Rapid, BeforeAnArcIsThatOfTheArc) {
  const Toolpath path =
      path_of(apt("GOTO/20,50,9\nRAPID\nMOVARC/30,50,9,0,0,1,10,ANGLE,180\nGOTO/40,50,9\nGOTO/40,60,9\nFINI\n"));
  EXPECT_EQ(rapids_of(path), (Rapids{false, true, false}));
  EXPECT_EQ(path.moves[1].kind, MoveKind::arc);
}

TEST(Rapid, OfACycleIsAllButThePlunge) {
  const std::string begin = "GOTO/0,0,60\nCYCLE/",
                    end = ",DEPTH,5,MMPM,100,CLEAR,3,RETURN,9\nGOTO/9,0,0\nCYCLE/OFF\nFINI\n";
  EXPECT_EQ(rapids_of(path_of(apt(begin + "DRILL" + end))), (Rapids{false, true, true, false, true}));
  // A bored hole is left at the feed up to the clearance.
  const Toolpath bored = path_of(apt(begin + "BORE" + end));
  EXPECT_EQ(rapids_of(bored), (Rapids{false, true, true, false, false, true}));
  expect_vector(bored.moves[4].end.tip, 9, 0, 3);
  expect_vector(bored.moves[5].end.tip, 9, 0, 9);
}

TEST(Rapid, OfAListMayHoldForAllItsPositions) {
  const Toolpath path =
      path_of(apt("MULTAX/OFF\nGOTO/20,50,60\nRAPID\nGOTO/20,50,11,30,50,5,40,50,5\nGOTO/40,50,60\nFINI\n"));
  EXPECT_EQ(rapids_of(path), (Rapids{false, true, true, true, false}));
  EXPECT_EQ(path.moves[3].kind, MoveKind::feed) << "so that --rapid skip does not leave it out";
  EXPECT_EQ(rapids_of(path_of(apt("MULTAX/OFF\nGOTO/20,50,60\nGOTO/20,50,11,30,50,5\nFINI\n"))), Rapids(3, false));
}

TEST(Rapid, MayHoldBehindAFrom) {
  const std::string begin = "GOTO/20,50,60\nRAPID\nFROM/20,50,20\n", end = "GOTO/20,50,5\nGOTO/20,50,60\nFINI\n";
  EXPECT_EQ(rapids_of(path_of(apt(begin + end))), (Rapids{false, true, true, false}));
  EXPECT_EQ(rapids_of(path_of(apt(begin + "FEDRAT/100\n" + end))), (Rapids{false, true, false, false}));
  EXPECT_EQ(path_of(apt(begin + "RAPID\n" + end)).moves[2].kind, MoveKind::rapid);
}

TEST(Cards, HaveNumbersInTheirLastColumns) {
  const auto card = [](std::string text, const std::string& number) {
    text.resize(72, ' ');
    return text + number + "\n";
  };
  const Toolpath path =
      path_of(card("PARTNO A", "00000010") + card("UNITS/MM", "00000020") + card("CUTTER/10", "00000030") +
              card("LOADTL/1", "00000040") + card("GOTO/1,2,3", "00000050") + card("FINI", "00000060"));
  ASSERT_EQ(path.moves.size(), 1U);
  EXPECT_EQ(unchecked(path), 0U);
  expect_vector(path.moves[0].end.tip, 1, 2, 3);
}

TEST(FurtherReadings, RepeatNoMovesOfAnotherTool) {
  const std::string begin = "GOTO/0,0,9\nINDEX/1\nGOTO/1,0,9\nGOTO/2,0,9\n";
  for (const std::string& text : {begin + "INDEX/1,NOMORE\nLOADTL/2\n", begin + "LOADTL/2\nINDEX/1,NOMORE\n"})
    EXPECT_FALSE(path_of(apt(text + "COPY/1,TRANSL,0,10,0,2\nFINI\n")).moves.back().not_checked_reason.empty()) << text;
}

TEST(FurtherReadings, RepeatNoMovesWhereTheSpindleStopsOrStarts) {
  const std::string begin = "GOTO/0,0,9\nINDEX/1\nGOTO/1,0,9\nGOTO/2,0,9\n", end = "INDEX/1,NOMORE\n";
  const std::string copy = "COPY/1,TRANSL,0,10,0,2\nGOTO/0,0,50\nFINI\n";
  EXPECT_TRUE(path_of(apt(begin + end + copy)).moves.back().not_checked_reason.empty());
  for (const std::string& text :
       {begin + "SPINDL/OFF\n" + end, begin + end + "SPINDL/OFF\n", begin + "SPINDL/OFF\n" + end + "SPINDL/ON\n"})
    EXPECT_FALSE(path_of(apt(text + copy)).moves.back().not_checked_reason.empty()) << text;
}

TEST(FurtherReadings, RepeatNoMovesWhereARapidIsOpen) {
  const std::string begin = "GOTO/0,0,9\nINDEX/1\nGOTO/1,0,9\nGOTO/2,0,9\n", end = "GOTO/0,0,50\nFINI\n";
  for (const std::string& text : {begin + "RAPID\nINDEX/1,NOMORE\nCOPY/1,TRANSL,0,10,0,2\n",
                                  begin + "INDEX/1,NOMORE\nRAPID\nCOPY/1,SAME\n", begin + "RAPID\nCOPY/1,SAME\n"}) {
    const Toolpath path = path_of(apt(text + end));
    EXPECT_FALSE(path.moves.back().not_checked_reason.empty()) << text;
  }
  const Toolpath rapid = path_of(apt(begin + "RAPID\nGOTO/3,0,9\nINDEX/1,NOMORE\nCOPY/1,TRANSL,0,10,0,2\n" + end));
  EXPECT_TRUE(rapid.moves.back().not_checked_reason.empty());
}

}  // namespace
}  // namespace gouge::further_readings_test
