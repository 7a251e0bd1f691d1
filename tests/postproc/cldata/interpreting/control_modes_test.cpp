// Text for the control with a code of planes, arc centres or cycles: arcs and holes behind it may have another meaning.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/postproc/cldata/path_of.h"

namespace gouge::control_modes_test {
namespace {

using Lines = std::set<std::size_t>;

constexpr const char* kCreo =
    "$$* Pro/CLfile  Version 2.0 - T\nPARTNO / T\nUNITS / MM\n$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nLOADTL / 1\n"
    "$$-> CUTTER / 10.000000\nFEDRAT / 100.000000,  MMPM\nGOTO / 0, 0, 9\n";
constexpr const char* kPlain = "UNITS/MM\nCUTTER/10\nLOADTL/1\nFEDRAT/100,MMPM\nGOTO/0,0,9\n";

// Returns the lines of `text`, from 1, with moves that are not checked, behind a feed to 0,0,9.
Lines open_lines(const std::string& text, const std::string& head = kCreo) {
  Lines lines;
  const auto before = static_cast<std::size_t>(std::ranges::count(head, '\n'));
  const Toolpath path = path_of(head + text + "FINI\n");
  for (const Move& move : path.moves) {
    if (!move.not_checked_reason.empty()) lines.insert(move.line - before);
  }
  return lines;
}

constexpr const char* kArc = "CIRCLE/5,0,9,0,0,1,5\nGOTO/5,5,9\n";       // from 0,0,9, about Z
constexpr const char* kUpright = "CIRCLE/5,0,9,0,1,0,5\nGOTO/5,0,14\n";  // from 0,0,9, about Y

TEST(ControlModes, OfAnotherPlaneConcernArcsInThePlaneBefore) {
  for (const std::string text : {"INSERT G18\n", "PREFUN/19\n", "INSERT G19 M8\n"}) {
    EXPECT_EQ(open_lines(text + kArc), Lines{3}) << text;
    EXPECT_EQ(open_lines(text + "GOTO/1,0,9\n"), Lines{}) << text;
    EXPECT_EQ(open_lines(text + "INSERT G17\n" + kArc), Lines{}) << text;
  }
  EXPECT_EQ(open_lines(std::string("INSERT G17\n") + kArc), Lines{});
}

TEST(ControlModes, EndWhereTheFileItselfChangesThePlane) {
  EXPECT_EQ(open_lines(std::string("INSERT G18\n") + kUpright + "GOTO/0,0,9\n" + kArc), Lines{});
  EXPECT_EQ(open_lines(std::string("INSERT G19\n") + kUpright + "GOTO/0,0,9\n" + kArc), Lines{});
  EXPECT_EQ(open_lines(std::string(kUpright) + "GOTO/0,0,9\nINSERT G17\n" + kUpright), Lines{6});
}

TEST(ControlModes, OfAnotherArcCentreConcernAllArcs) {
  EXPECT_EQ(open_lines(std::string("INSERT G90.1\n") + kArc), Lines{3});
  EXPECT_EQ(open_lines(std::string("INSERT G90.1\nINSERT G91.1\n") + kArc), Lines{});
}

constexpr const char* kCycle = "CYCLE/DRILL,RAPTO,2,FEDTO,-5,MMPM,100,RTRCTO,9\n";

TEST(ControlModes, OfCyclesLeaveLaterHolesOpen) {
  for (const std::string code : {"G99", "G98", "G80", "G1", "G0", "G18", "G83", "G90", "MCALL"}) {
    const std::string text = std::string(kCycle) + "GOTO/1,1,0\nINSERT " + code + "\nGOTO/2,1,0\nCYCLE/OFF\n";
    EXPECT_TRUE(open_lines(text, kPlain).contains(4)) << code;
    EXPECT_FALSE(open_lines(text, kPlain).contains(2)) << code;
  }
  const std::string harmless = std::string(kCycle) + "GOTO/1,1,0\nINSERT M8\nGOTO/2,1,0\nCYCLE/OFF\n";
  EXPECT_FALSE(open_lines(harmless, kPlain).contains(4));
}

TEST(ControlModes, BeforeACycleCountToo) {
  const std::string holes = std::string(kCycle) + "GOTO/1,1,0\nCYCLE/OFF\n";
  EXPECT_TRUE(open_lines("INSERT G99\n" + holes, kPlain).contains(3));
  EXPECT_TRUE(open_lines("INSERT G18\n" + holes, kPlain).contains(3));
  EXPECT_FALSE(open_lines("INSERT G98\n" + holes, kPlain).contains(3)) << "the state at the start";
  EXPECT_FALSE(open_lines("INSERT G90 G80 G40 G17 G98\n" + holes, kPlain).contains(3)) << "a block of a safe start";
}

TEST(ControlModes, EndATiltedPlaneOrACompensationThatIsInForce) {
  EXPECT_EQ(open_lines("INSERT G69\nGOTO/1,0,9\n"), Lines{});
  EXPECT_EQ(open_lines("MULTAX/ON\nGOTO/1,0,9,0,.6,.8\nINSERT G69\nGOTO/2,0,9,0,.6,.8\n"), Lines{4});
  EXPECT_EQ(open_lines("INSERT G40\nGOTO/1,0,9\n"), Lines{});
}

TEST(ControlModes, BehindASlashAreNotUnderstood) {
  EXPECT_EQ(open_lines("INSERT//G55\nGOTO/1,0,9\n"), (Lines{1, 2}));
  EXPECT_EQ(open_lines("INSERT//M8\nGOTO/1,0,9\n"), Lines{});
}

}  // namespace
}  // namespace gouge::control_modes_test
