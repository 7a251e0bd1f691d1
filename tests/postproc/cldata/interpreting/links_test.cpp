// The connection of a position with the one before it where the file states no motion between them.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "postproc/cldata/interpreting/reasons.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::links_test {
namespace {

const std::string kBefore = "UNITS/MM\nLOADTL/1\nGOTO/1,0,0\nGOTO/2,0,0\n";

// Returns the move of the position after `between`, the third.
Move third_of(const std::string& between, const std::string& before = kBefore, const char* position = "GOTO/9,0,0\n") {
  const Toolpath path = path_of(before + between + position + "FINI\n");
  EXPECT_GE(path.moves.size(), 3U) << between;
  return path.moves.size() < 3 ? Move{} : path.moves[2];
}

bool is_linked_after(const std::string& between, const std::string& before = kBefore) {
  const Move move = third_of(between, before);
  EXPECT_FALSE(move.has_start) << between;
  EXPECT_TRUE(move.not_checked_reason.empty()) << move.not_checked_reason;
  return move.is_linked;
}

std::string block(const char* tool, const char* diameter, const char* origin, const char* load) {
  return std::string("TOOL PATH/A,TOOL,") + tool + "\nTLDATA/MILL," + diameter + ",0.0,75.0,0.0,0.0\nMSYS/0,0," +
         origin + ",1,0,0,0,1,0\n" + load;
}

TEST(Links, AFrameMovesNothing) {
  const std::string rows = "$$*CATIA0\n$$ axis\n$$ 1.0 0.0 0.0 0.0\n$$ 0.0 1.0 0.0 0.0\n$$ 0.0 0.0 1.0 ";
  EXPECT_TRUE(is_linked_after(rows + "5.0\n", "UNITS/MM\n" + rows + "0.0\nLOADTL/1\nGOTO/1,0,0\nGOTO/2,0,0\n"));
  const auto mcsys = [](const char* z) {
    return "MCSYS/ NUM,1,POINT,0,0," + std::string(z) + ",VECTOR,1,0,0,VECTOR,0,1,0\n";
  };
  EXPECT_TRUE(is_linked_after(mcsys("5"), "UNITS/MM\n" + mcsys("0") + "LOADTL/1\nGOTO/1,0,0\nGOTO/2,0,0\n"));
  const auto mcs = [](const char* z) { return "MCS/1,0,0,$\n0,1,0,$\n0,0,1,$\n0,0," + std::string(z) + "\n"; };
  EXPECT_TRUE(is_linked_after(mcs("5"), "UNITS/MM\n" + mcs("0") + "LOADTL/1\nGOTO/1,0,0\nGOTO/2,0,0\n"));
}

TEST(Links, ABlockOfNxWithAnotherFrameIsLinkedInPartCoordinates) {
  const std::string positions = "GOTO/1,0,0\nGOTO/2,0,0\nEND-OF-PATH\n";
  const Toolpath path = path_of(block("F10", "10.0", "5", "LOAD/TOOL,1\n") + positions +
                                block("F10", "10.0", "7", "LOAD/TOOL,1\n") + positions);
  ASSERT_EQ(path.moves.size(), 4U);
  EXPECT_TRUE(path.moves[2].is_linked);
  EXPECT_NEAR(path.moves[1].end.tip.z(), 5, 1e-12);
  EXPECT_NEAR(path.moves[2].end.tip.z(), 7, 1e-12);
}

TEST(Links, ANumberThatIsLoadedAgainIsTheSameToolInAnyWords) {
  for (const char* again : {"TOOLNO/1,10.\nLOADTL/1\n", "TLDATA/MILL,10,0,75,0,0\nLOADTL/1\n", "CUTTER/10\nLOADTL/1\n"})
    EXPECT_TRUE(is_linked_after(again)) << again;
  EXPECT_TRUE(is_linked_after("CUTTER/10.0001\nLOADTL/1\n", "UNITS/MM\nCUTTER/10\n" + kBefore.substr(9)));
  EXPECT_FALSE(is_linked_after("LOADTL/2\n"));
  EXPECT_FALSE(is_linked_after("CUTTER/10\nLOADTL/2\n"));
}

TEST(Links, AToolOfNxIsKnownByItsNumberAndWithoutOneByItsName) {
  const auto is_linked = [](const std::string& again, const char* load) {
    const std::string positions = "GOTO/1,0,0\nGOTO/2,0,0\nEND-OF-PATH\n";
    const Toolpath path = path_of(block("F10", "10.0", "0", load) + positions + again + positions);
    return path.moves.size() == 4 && path.moves[2].is_linked;
  };
  const char* const load = "LOAD/TOOL,1\n";
  EXPECT_TRUE(is_linked(block("F10", "10.0001", "0", load), load));
  EXPECT_TRUE(is_linked(block("F10_B", "10.0", "0", load), load));
  EXPECT_FALSE(is_linked(block("F10", "10.0", "0", "LOAD/TOOL,2\n"), load));
  EXPECT_TRUE(is_linked(block("F10", "10.0001", "0", ""), ""));
  EXPECT_TRUE(is_linked(block("F10", "10.0", "0", ""), load));
  EXPECT_FALSE(is_linked(block("F10_B", "10.0", "0", ""), ""));
}

TEST(Links, APlaceThatIsUnknownStaysSoOverWordsThatMoveNothing) {
  for (const char* words : {"TOOLNO/1,10.\nLOADTL/1\n", "CUTTER/10\nLOADTL/1\n", "FROM/5,0,0\n"}) {
    const Move move = third_of(std::string("RETRCT\n") + words);
    EXPECT_FALSE(move.is_linked);
    EXPECT_EQ(kind_of(move.not_checked_reason), ReasonKind::after_retract) << words;
  }
  EXPECT_TRUE(third_of("RETRCT\nLOADTL/2\n").not_checked_reason.empty());
  EXPECT_TRUE(third_of("RETRCT\nGOHOME\n").not_checked_reason.empty());
}

TEST(Links, OnlyTheHomeOfAllLinearAxesLeavesTheNextPositionAlone) {
  for (const char* home :
       {"GOHOME\n", "GOHOME/X,Y,Z\n", "GOHOME / Z\nGOHOME / X,Y\n", "GOHOME/ZAXIS,A\nGOHOME/X,Y,C\n"}) {
    const Move move = third_of(home);
    EXPECT_TRUE(!move.has_start && !move.is_linked && move.not_checked_reason.empty()) << home;
  }
  for (const char* home : {"GOHOME/Z\n", "GOHOME/A,Z\n", "GOHOME / Z\nGOHOME / X\n", "GOHOME/Z\nGOHOME/C\n",
                           "GOHOME/Z\nLOADTL/1\n", "GOHOME/Z\nFROM/5,0,0\n"}) {
    const Move move = third_of(home);
    EXPECT_EQ(kind_of(move.not_checked_reason), ReasonKind::after_retract) << home;
  }
  EXPECT_TRUE(third_of("GOHOME/Z\nLOADTL/2\n").not_checked_reason.empty());
}

TEST(Links, AnAxisThatGoesHomeBeforeZTakesAWayThatIsNotStated) {
  for (const char* home : {"GOHOME/C\n", "GOHOME/A\n", "GOHOME/X\n", "GOHOME/Y\n", "GOHOME/X,Y\n"}) {
    for (const char* next : {"GOTO/9,0,0\n", "LOADTL/2\nGOTO/9,0,0\n", "GOHOME/Z\nGOHOME/X,Y\nGOTO/9,0,0\n", ""}) {
      const Move move = third_of(home, kBefore, next);
      EXPECT_EQ(kind_of(move.not_checked_reason), ReasonKind::unread) << home << next;
      EXPECT_EQ(move.line, 5U);
    }
    EXPECT_EQ(path_of("UNITS/MM\nLOADTL/1\n" + std::string(home) + "GOTO/9,0,0\nFINI\n").moves.size(), 1U);
  }
}

TEST(Links, AStepAfterRetrctStartsAtThePositionBeforeOrInThePlane) {
  for (const char* plane : {"", "CLEARP/XYPLAN,50\n"}) {
    const Toolpath path = path_of(kBefore + plane + "RETRCT\nGODLTA/0,10,0\nGOTO/9,0,0\nFINI\n");
    const std::size_t step = path.moves.size() - 2;
    EXPECT_EQ(kind_of(path.moves[step].not_checked_reason), ReasonKind::unread) << plane;
    EXPECT_FALSE(path.moves[step + 1].has_start) << plane;
  }
  const Toolpath stands = path_of(kBefore + "CLEARP/XYPLAN,0\nRETRCT\nGODLTA/0,10,0\nFINI\n");
  for (const Move& move : stands.moves) EXPECT_TRUE(move.not_checked_reason.empty() || move.is_covered());
}

// Returns the lines of the positions to which the file states no way.
std::vector<std::size_t> lines_of_stretches(const std::string& text) {
  std::vector<std::size_t> lines;
  for (const Move& move : path_of(text).moves) {
    if (move.begins_stretch) lines.push_back(move.line);
  }
  return lines;
}

TEST(Stretches, BeginAtTheFirstPositionOfFileAndToolAndAfterHome) {
  using Lines = std::vector<std::size_t>;
  EXPECT_EQ(lines_of_stretches(kBefore + "GOTO/3,0,0\nFINI\n"), Lines{3});
  EXPECT_EQ(lines_of_stretches(kBefore + "LOADTL/2\nGOTO/3,0,0\nFINI\n"), (Lines{3, 6}));
  EXPECT_EQ(lines_of_stretches(kBefore + "GOHOME\nGOTO/3,0,0\nFINI\n"), (Lines{3, 6}));
  EXPECT_EQ(lines_of_stretches(kBefore + "LOADTL/1\nFROM/3,0,0\nFINI\n"), Lines{3}) << "linked";
  EXPECT_EQ(lines_of_stretches(kBefore + "RETRCT\nGOTO/3,0,0\nFINI\n"), Lines{3}) << "not checked";
  EXPECT_EQ(lines_of_stretches("UNITS/MM\nLOADTL/1\nFROM/0,0,9\nGOTO/1,0,0\nFINI\n"), Lines{3});
  EXPECT_EQ(lines_of_stretches("UNITS/MM\nLOADTL/1\nINDEX/1\nGOTO/1,0,0\nGOTO/2,0,0\nINDEX/1,NOMORE\n"
                               "COPY/1,TRANSL,5,0,0,2\nFINI\n"),
            Lines{4});
}

}  // namespace
}  // namespace gouge::links_test
