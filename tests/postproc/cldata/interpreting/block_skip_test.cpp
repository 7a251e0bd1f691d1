// OPSKIP/ON to OFF runs or is left out. A state that differs between both readings is unknown behind it.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "lib/path/run_kind.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::block_skip_test {
namespace {

std::string apt(const std::string& text) { return "UNITS/MM\nCUTTER/10\nLOADTL/1\n" + text + "FINI\n"; }

std::string catia(const std::string& text) {
  return "$$ CATIA APT VERSION 1.0\nMULTAX\nCUTTER/10\nLOADTL/1\n" + text + "END\n";
}

std::string nx(const std::string& text) {
  return "TOOL PATH/A,TOOL,T\nTLDATA/MILL,10.,0.,50.,0.,0.\nFEDRAT/MMPM,100.\n" + text + "END-OF-PATH\n";
}

std::string skipped(const std::string& text) { return "OPSKIP/ON\n" + text + "OPSKIP/OFF\n"; }

// Returns the lines of moves that are not checked in any reading.
std::set<std::size_t> open_lines(const std::string& text) {
  std::set<std::size_t> lines;
  const Toolpath path = path_of(text);
  for (const Move& move : path.moves) {
    if (!move.not_checked_reason.empty() && !move.is_covered()) lines.insert(move.line);
  }
  return lines;
}

using Lines = std::set<std::size_t>;

TEST(BlockSkip, IsCheckedRunAndLeftOut) {
  const Toolpath path = path_of(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "GOTO/9,0,20\nGOTO/9,0,9\n"));
  ASSERT_EQ(path.moves.size(), 6U);
  for (const std::size_t i : {1U, 2U, 3U, 4U}) EXPECT_TRUE(path.moves[i].is_covered()) << i;
  expect_vector(path.moves[3].end.tip, 0, 0, 9);  // before the skip
  EXPECT_FALSE(path.moves[3].has_start);
  expect_vector(path.moves[4].end.tip, 9, 0, 20);
  EXPECT_TRUE(path.moves[4].has_start);
  EXPECT_TRUE(path.moves[5].not_checked_reason.empty());
}

TEST(BlockSkip, KeepsTheKindOfTheMotionBehindIt) {
  const Toolpath feed = path_of(apt("FEDRAT/100,MMPM\nGOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "GOTO/9,0,20\n"));
  ASSERT_EQ(feed.moves.size(), 5U);
  EXPECT_FALSE(runs_rapid(feed.moves[4]));
  const Toolpath rapid = path_of(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "RAPID\nGOTO/9,0,20\n"));
  ASSERT_EQ(rapid.moves.size(), 5U);
  EXPECT_TRUE(runs_rapid(rapid.moves[4]));
}

TEST(BlockSkip, ThatChangesNothingLeavesMovesChecked) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("COOLNT/ON\n") + "CIRCLE/5,0,9,0,0,1,5\nGOTO/10,0,9\n")), Lines{});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("FEDRAT/100,MMPM\n") + "GODLTA/0,0,9\n")), Lines{});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("RAPID\nGOTO/0,0,20\n") + "GOTO/0,0,9\n")), Lines{});
  EXPECT_EQ(open_lines(catia("GOTO/0,0,9,0,0,1\n" + skipped("GOTO/0,0,20,.6,0,.8\n") +
                             "GOTO/9,0,9,0,0,1\nMULTAX/OFF\nGOTO/9,0,5\n")),
            Lines{});
}

TEST(BlockSkip, WithRapidOrFeedLeavesTheKindOfTheNextMotionOpen) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("RAPID\n") + "GOTO/0,0,5\nGOTO/9,0,5\n")), Lines{8});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\nRAPID\n" + skipped("FEDRAT/9,MMPM\n") + "GOTO/0,0,5\nGOTO/9,0,5\n")), Lines{9});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\nRAPID\n" + skipped("GOTO/1,0,9\n") + "GOTO/0,0,5\nGOTO/9,0,5\n")), Lines{9});
}

TEST(BlockSkip, EndsItsDoubtWhereTheKindIsStated) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("RAPID\n") + "FEDRAT/9,MMPM\nGOTO/0,0,5\n")), Lines{});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("RAPID\n") + "RAPID\nGOTO/0,0,5\n")), Lines{});
}

TEST(BlockSkip, KeepsADoubtOfTheKindOverAFrom) {
  EXPECT_TRUE(open_lines(apt("GOTO/0,0,9\n" + skipped("RAPID\n") + "FROM/0,0,9\nGOTO/9,0,5\n")).contains(9));
}

TEST(BlockSkip, WithAStepLeavesStepsBehindItOpen) {
  const std::string behind = "GODLTA/0,0,1\nGODLTA/9,0,0\nGOTO/9,0,9\nGOTO/9,9,9\n";
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GODLTA/0,0,9\n") + behind)), (Lines{8, 9, 10}));
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + behind)), (Lines{8, 9, 10}));
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GODLTA/0,0,9\n") + "GOTO/9,0,9\nGODLTA/0,0,1\n")), Lines{});
}

TEST(BlockSkip, WithAWayHomeLeavesTheNextMotionOpen) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOHOME\n") + "GOTO/9,0,9\nGOTO/9,9,9\n")), Lines{8});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("RETRCT\n") + "GOTO/9,0,9\nGOTO/9,9,9\n")), Lines{8});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOHOME\n") + "GOHOME\nGOTO/9,0,9\n")), Lines{});
}

TEST(BlockSkip, IsLinkedToAPositionBehindABreak) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "FROM/9,0,20\nGOTO/9,0,9\n")), Lines{8});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "GOHOME\nGOTO/9,0,9\n")), Lines{6})
      << "its way home";
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "CUTTER/6\nLOADTL/2\nGOTO/9,0,9\n")), Lines{6});
}

TEST(BlockSkip, LeavesArcsAtItsBordersOpen) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + "CIRCLE/5,0,20,0,0,1,5\nGOTO/10,0,20\n")),
            Lines{9});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\nCIRCLE/5,0,9,0,0,1,5\n" + skipped("GOTO/10,0,9\n") + "GOTO/20,0,9\n")),
            (Lines{5, 7, 9}));
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("CIRCLE/5,0,9,0,0,1,5\n") + "GOTO/10,0,9\nGOTO/20,0,9\n")),
            (Lines{6, 8}));
}

TEST(BlockSkip, WithAnAxisThatStaysLeavesTheAxisOpen) {
  EXPECT_EQ(open_lines(nx("GOTO/0.,0.,9.\n" + skipped("GOTO/0.,0.,20.,0.,-1.,0.\n") +
                          "GOTO/9.,0.,9.\nGOTO/9.,9.,9.\nGOTO/0.,9.,9.,0.,0.,1.\nGOTO/0.,0.,9.\n")),
            (Lines{8, 9, 10}));
  EXPECT_EQ(open_lines(nx("GOTO/0.,0.,9.\n" + skipped("GOTO/0.,0.,20.,0.,0.,1.\n") + "GOTO/9.,0.,9.\n")), Lines{});
  EXPECT_EQ(open_lines(
                catia("GOTO/0,0,9,0,0,1\n" + skipped("GOTO/0,0,20,0,-1,0\n") + "MULTAX/OFF\nGOTO/9,0,9\nGOTO/9,9,9\n")),
            (Lines{10, 11}));
}

TEST(BlockSkip, WithAPlaneLeavesRetractsOpen) {
  const std::string behind = "RETRCT\nGOTO/9,0,9\nGOTO/9,9,9\n";
  EXPECT_EQ(open_lines(apt("CLEARP/XYPLAN,50\nGOTO/0,0,9\n" + skipped("CLEARP/XYPLAN,90\n") + behind)), Lines{10});
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("CLEARP/XYPLAN,90\n") + behind)), Lines{9});
  EXPECT_EQ(open_lines(apt("CLEARP/XYPLAN,50\nGOTO/0,0,9\n" + skipped("CLEARP/XYPLAN,50\n") + behind)), Lines{});
}

TEST(BlockSkip, WithALastingStateLeavesAllThatFollowsOpen) {
  for (const std::string state : {"INSERT G55\n", "INSERT G90\n", "CYCLE/OFF\n", "MODE/MILL\n", "LOADTL/2\n",
                                  "CUTCOM/OFF\n", "ROTABL/90\n", "MOVNRB/OFF\n"}) {
    const Lines lines = open_lines(apt("GOTO/0,0,9\n" + skipped(state) + "GOTO/9,0,9\nGOTO/9,9,9\n"));
    EXPECT_TRUE(lines.contains(8) && lines.contains(9)) << state;
  }
}

TEST(BlockSkip, BehindARetractOrCompensationHasNoOtherStart) {
  EXPECT_EQ(open_lines(apt("CLEARP/XYPLAN,50\nGOTO/0,0,9\nRETRCT\n" + skipped("GOTO/0,0,60\n") + "GOTO/9,0,60\n")),
            Lines{10});
  EXPECT_TRUE(
      open_lines(apt("GOTO/0,0,9\nCUTCOM/LEFT\nGOTO/1,0,9\nCUTCOM/OFF\n" + skipped("GOTO/0,0,60\n") + "GOTO/9,0,60\n"))
          .contains(11));
}

TEST(BlockSkip, TwiceWithoutAMotionBetweenIsNotChecked) {
  EXPECT_EQ(open_lines(apt("GOTO/0,0,9\n" + skipped("GOTO/0,0,20\n") + skipped("GOTO/0,0,30\n") + "GOTO/9,0,30\n")),
            Lines{11});
}

TEST(BlockSkip, LeavesTheWayOpenOnWhichTheToolLeaves) {
  const std::string out = "GOTO/0,0,9\nGOTO/5,0,9\n" + skipped("GOTO/5,0,50\n");
  EXPECT_EQ(open_lines(apt(out)), Lines{7}) << "FINI";
  EXPECT_EQ(open_lines(apt(out + "LOADTL/2\nGOTO/0,0,60\n")), Lines{7});
  EXPECT_EQ(open_lines(apt(out + "GOHOME\nGOTO/0,0,60\n")), Lines{7});
  EXPECT_EQ(open_lines(apt(out + "GOTO/0,0,60\n")), Lines{}) << "both motions to a position that the file states";
}

}  // namespace
}  // namespace gouge::block_skip_test
