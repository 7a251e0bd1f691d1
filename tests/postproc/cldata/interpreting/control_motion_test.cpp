// Text for the control with a motion code: positions behind it may run with that code.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/postproc/cldata/path_of.h"

namespace gouge::control_motion_test {
namespace {

using Lines = std::set<std::size_t>;

// Returns the lines of moves that are not checked in a file with one feed position, in line 5, before `text`.
Lines open_lines(const std::string& text) {
  Lines lines;
  const Toolpath path = path_of("UNITS/MM\nCUTTER/10\nLOADTL/1\nFEDRAT/100,MMPM\nGOTO/0,0,9\n" + text + "FINI\n");
  for (const Move& move : path.moves) {
    if (!move.not_checked_reason.empty()) lines.insert(move.line);
  }
  return lines;
}

TEST(ControlMotion, OfAnotherCodeHoldsUntilTheKindChanges) {
  const std::string behind = "GOTO/1,0,9\nFEDRAT/50,MMPM\nGOTO/2,0,9\nRAPID\nGOTO/3,0,9\nGOTO/4,0,9\n";
  for (const std::string text : {"INSERT G0\n", "INSERT G2\n", "INSERT G03\n", "PREFUN/0\n", "INSERT G33\n", "G0\n"})
    EXPECT_EQ(open_lines(text + behind), (Lines{7, 9})) << text;
}

TEST(ControlMotion, OfTheSameCodeHasNoEffect) {
  EXPECT_EQ(open_lines("INSERT G1\nGOTO/1,0,9\n"), Lines{});
  EXPECT_EQ(open_lines("RAPID\nGOTO/1,0,9\nINSERT G0\nRAPID\nGOTO/2,0,9\nGOTO/3,0,9\n"), Lines{});
  EXPECT_EQ(open_lines("INSERT G0\nRAPID\nGOTO/2,0,9\nGOTO/3,0,9\n"), Lines{});
}

TEST(ControlMotion, EndsWithTheCodeOfTheLastMotion) {
  EXPECT_EQ(open_lines("INSERT G0\nINSERT G1\nGOTO/1,0,9\n"), Lines{});
  EXPECT_EQ(open_lines("INSERT G0\nGOTO/1,0,9\nINSERT G1\nGOTO/2,0,9\n"), Lines{7});
}

TEST(ControlMotion, BehindAnArcOrABreakConcernsEitherKind) {
  EXPECT_EQ(open_lines("CIRCLE/5,0,9,0,0,1,5\nGOTO/10,0,9\nINSERT G0\nGOTO/10,9,9\n"), (Lines{7, 9}));
  EXPECT_EQ(open_lines("GOHOME\nINSERT G0\nGOTO/1,0,9\nGOTO/2,0,9\n"), (Lines{8, 9}));
}

TEST(ControlMotion, IsNotEndedByAnArc) {
  EXPECT_EQ(open_lines("INSERT G0\nCIRCLE/5,0,9,0,0,1,5\nGOTO/10,0,9\nGOTO/10,9,9\n"), (Lines{8, 9}));
}

TEST(ControlMotion, IsLeftOpenByAMoveOfTheText) {
  EXPECT_EQ(open_lines("INSERT G0 Z50.\nGOTO/1,0,9\nGOTO/2,0,9\n"), (Lines{6, 7, 8}));
}

TEST(ControlMotion, IsNotChangedByOtherText) {
  EXPECT_EQ(open_lines("INSERT G4 P1\nGOTO/1,0,9\nINSERT M8\nGOTO/2,0,9\nINSERT G5 P0\nGOTO/3,0,9\n"), Lines{});
}

}  // namespace
}  // namespace gouge::control_motion_test
