// Binary NCCS records beside the ASCII that states the same: one interpreter reads both, so the moves are the same.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>

#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/nccs_file.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/postproc/cldata/same_moves.h"

namespace gouge::nccs_records_test {
namespace {

constexpr Minor kLeft{8}, kRight{24}, kOn{71}, kOff{72}, kIpm{73}, kAuto{88}, kStep{92}, kAdjust{159}, kDrill{163},
    kDeep{153}, kThru{152}, kBore9{213}, kRapto{280}, kFedto{281}, kRtrcto{295}, kMmpm{315}, kDwell{197}, kOffset{814};

Toolpath text_of(const std::string& body) { return path_of("REMARK a.as NCLCAM 2019.00\n" + body + "FINI\n"); }

void expect_twins(const NccsFile& binary, const std::string& body) {
  expect_same_moves(path_of(binary.bytes()), text_of(body));
}

TEST(NccsWords, AreDistinguishedFromNumbersByTheirHighestHalf) {
  NccsFile file;
  file.multax(false).post(1009, {kMmpm, 250.0}).points({1, 2, 3}).points({4, 2, 3});
  expect_twins(file, "MULTAX/OFF\nFEDRAT/MMPM,250\nGOTO/1,2,3\nGOTO/4,2,3\n");
  const Toolpath path = path_of(file.bytes());
  EXPECT_NEAR(path.moves.at(1).feed_mm, 250, 1e-12);
  EXPECT_EQ(path.unit, LengthUnit::mm);
}

TEST(NccsWords, InchesAreReportedByTheirFeedWord) {
  NccsFile file;
  file.multax(false).post(1009, {kIpm, 10.0}).points({1, 2, 3}).points({4, 2, 3});
  expect_twins(file, "MULTAX/OFF\nFEDRAT/IPM,10\nGOTO/1,2,3\nGOTO/4,2,3\n");
  expect_vector(path_of(file.bytes()).moves.at(0).end.tip, 25.4, 50.8, 76.2);
}

TEST(NccsWords, TextIsNeverReadAsNumbers) {
  NccsFile file;
  file.multax(false).record(2000, 1015, "PWORKS  ").record(2000, 1044, "ROUGHING ALONG X");
  file.record(2000, 1199, "XYZXYZXYABCDEFGHABCDEFGHABCDEFGH").points({1, 2, 3});
  const Toolpath path = path_of(file.bytes());
  ASSERT_EQ(path.moves.size(), 1u);
  EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
  ASSERT_EQ(path.operations.size(), 1u);
  EXPECT_EQ(path.operations[0].name, "ROUGHING ALONG X");
}

TEST(NccsCycle, GoesDownFromItsPositionAndUpAgain) {
  NccsFile file;
  file.multax(true).points({0, 0, 50, 0, 0, 1});
  file.post(1054, {kDrill, kFedto, 12.5, kMmpm, 80.0, kRapto, 2.0, kDwell, 1.0, kRtrcto, 10.0});
  file.points({10, 0, 0, 0, 0, 1}).points({20, 0, 0, 0, 0, 1}).post(1054, {kOff}).points({30, 0, 50, 0, 0, 1});
  expect_twins(file,
               "MULTAX/ON\nGOTO/0,0,50,0,0,1\nCYCLE/DRILL,FEDTO,12.5,MMPM,80,RAPTO,2,DWELL,1,RTRCTO,10\n"
               "GOTO/10,0,0,0,0,1\nGOTO/20,0,0,0,0,1\nCYCLE/OFF\nGOTO/30,0,50,0,0,1\n");
  const Toolpath path = path_of(file.bytes());
  ASSERT_EQ(path.moves.size(), 10u);  // across, down to the clearance, to the bottom, up; twice
  double lowest = 1, highest = 0;
  for (std::size_t i = 1; i < 9; ++i) {
    EXPECT_EQ(path.moves[i].kind, MoveKind::cycle);
    EXPECT_TRUE(path.moves[i].not_checked_reason.empty());
    lowest = std::min(lowest, path.moves[i].end.tip.z());
    highest = std::max(highest, path.moves[i].end.tip.z());
  }
  EXPECT_NEAR(lowest, -12.5, 1e-12);
  EXPECT_NEAR(path.moves[8].end.tip.z(), 10, 1e-12);
  EXPECT_TRUE(path.moves[9].not_checked_reason.empty());
}

TEST(NccsCycle, TwoNumbersAfterFedtoAreADiameterAndTheAngleOfTheTip) {
  NccsFile file;
  file.multax(true).points({0, 0, 50, 0, 0, 1});
  file.post(1054, {kDrill, kFedto, 10.0, 90.0, kMmpm, 80.0, kRapto, 2.0}).points({10, 0, 0, 0, 0, 1});
  expect_twins(file, "MULTAX/ON\nGOTO/0,0,50,0,0,1\nCYCLE/DRILL,FEDTO,10,90,MMPM,80,RAPTO,2\nGOTO/10,0,0,0,0,1\n");
  double lowest = 1;
  for (const Move& move : path_of(file.bytes()).moves) lowest = std::min(lowest, move.end.tip.z());
  EXPECT_NEAR(lowest, -5, 1e-12);
}

struct CycleCase {
  std::vector<NccsFile::Argument> binary;
  std::string text;
  bool is_read;
};

TEST(NccsCycle, OnlyWhatGoesStraightDownAndUpIsRead) {
  const std::vector<CycleCase> cases = {
      {{kDrill, kFedto, 5.0, kRapto, 1.0}, "DRILL,FEDTO,5,RAPTO,1", true},
      {{Minor{81}, kFedto, 5.0, kRapto, 1.0}, "FACE,FEDTO,5,RAPTO,1", true},
      {{kThru, kFedto, 5.0, kRapto, 1.0, kStep, 1.0, 0.5}, "THRU,FEDTO,5,RAPTO,1,STEP,1,.5", true},
      {{kDeep, kFedto, 5.0, kRapto, 1.0, kStep, 2.0, kRtrcto, 0.5, 0.1},
       "DEEP,FEDTO,5,RAPTO,1,STEP,2,RTRCTO,.5,.1",
       true},
      {{kDeep, kFedto, 5.0, kRapto, 1.0, kStep, 2.0, kRtrcto, 9.0}, "DEEP,FEDTO,5,RAPTO,1,STEP,2,RTRCTO,9", false},
      {{kThru, kFedto, 5.0, kRapto, 1.0, kStep, 2.0, kRtrcto, 9.0}, "THRU,FEDTO,5,RAPTO,1,STEP,2,RTRCTO,9", false},
      {{Minor{168}, kFedto, 5.0, kIpm, 3.0, kRapto, 1.0}, "TAP,FEDTO,5,IPM,3,RAPTO,1", true},
      {{Minor{262}, kFedto, 5.0, kRapto, 1.0}, "REAM,FEDTO,5,RAPTO,1", true},
      {{Minor{1008}, kFedto, 5.0, kRapto, 1.0}, "REVERS,FEDTO,5,RAPTO,1", true},
      {{Minor{212}, kFedto, 5.0, kRapto, 1.0}, "BORE8,FEDTO,5,RAPTO,1", true},
      {{kBore9, kFedto, 5.0, kRapto, 1.0}, "BORE9,FEDTO,5,RAPTO,1", false},
      {{Minor{249}, kFedto, 5.0, kRapto, 1.0, kOffset, .2}, "SHIFT,FEDTO,5,RAPTO,1,OFFSET,.2", false},
      {{Minor{82}, kFedto, 5.0, kRapto, 1.0, kOffset, .2}, "BORE,FEDTO,5,RAPTO,1,OFFSET,.2", false},
      {{Minor{151}, kFedto, 5.0, kRapto, 1.0}, "MILL,FEDTO,5,RAPTO,1", false},
      {{Minor{75}, Minor{510}, 5.0, kRapto, 1.0}, "CIRCUL,DEPTH,5,RAPTO,1", false},
      {{kDrill, kFedto, 5.0}, "DRILL,FEDTO,5", false},
      {{kDrill, kFedto, -5.0, kRapto, 1.0}, "DRILL,FEDTO,-5,RAPTO,1", false},
      {{kDrill, kFedto, kRapto, 1.0}, "DRILL,FEDTO,RAPTO,1", false},
      {{kDrill, kFedto, 5.0, 200.0, kRapto, 1.0}, "DRILL,FEDTO,5,200,RAPTO,1", false},
      {{kDrill, kFedto, 5.0, kRapto, 1.0, Minor{1083}, 3.0}, "DRILL,FEDTO,5,RAPTO,1,REPEAT,3", false},
      {{kDrill, kFedto, 5.0, kRapto, 1.0, Minor{999}, 3.0}, "DRILL,FEDTO,5,RAPTO,1,STRANGE,3", false},
      {{kDrill, kFedto, 5.0, kRapto, 1.0, kFedto, 9.0}, "DRILL,FEDTO,5,RAPTO,1,FEDTO,9", false},
      {{Minor{327}}, "AVOID", false}};
  for (const CycleCase& c : cases) {
    SCOPED_TRACE(c.text);
    NccsFile file;
    file.multax(true).points({0, 0, 50, 0, 0, 1}).post(1054, c.binary).points({10, 0, 0, 0, 0, 1});
    expect_twins(file, "MULTAX/ON\nGOTO/0,0,50,0,0,1\nCYCLE/" + c.text + "\nGOTO/10,0,0,0,0,1\n");
    EXPECT_EQ(path_of(file.bytes()).moves.back().not_checked_reason.empty(), c.is_read);
  }
}

TEST(NccsCycle, AutoChangesNothingAndOnTakesTheLastOneUpAgain) {
  NccsFile file;
  file.multax(true).post(1054, {kAuto, kOff}).points({0, 0, 50, 0, 0, 1});
  file.post(1054, {kDrill, kFedto, 5.0, kRapto, 1.0}).post(1054, {kOff}).points({9, 0, 9, 0, 0, 1});
  file.post(1054, {kOn}).points({10, 0, 0, 0, 0, 1});
  expect_twins(
      file,
      "MULTAX/ON\nCYCLE/AUTO,OFF\nGOTO/0,0,50,0,0,1\nCYCLE/DRILL,FEDTO,5,RAPTO,1\nCYCLE/OFF\nGOTO/9,0,9,0,0,1\n"
      "CYCLE/ON\nGOTO/10,0,0,0,0,1\n");
  const Toolpath path = path_of(file.bytes());
  for (const Move& move : path.moves) EXPECT_TRUE(move.not_checked_reason.empty());
  EXPECT_EQ(path.moves.at(0).kind, MoveKind::feed);
  EXPECT_EQ(path.moves.back().kind, MoveKind::cycle);
}

TEST(NccsCutcom, OffIsOff) {
  NccsFile file;
  file.multax(true).points({0, 0, 0, 0, 0, 1}).post(1007, {kLeft, Minor{33}, 5.0}).points({1, 0, 0, 0, 0, 1});
  file.post(1007, {kOff}).points({2, 0, 0, 0, 0, 1}).points({3, 0, 0, 0, 0, 1});
  file.post(1007, {kRight}).points({4, 0, 0, 0, 0, 1}).post(1007, {kOff}).points({5, 0, 0, 0, 0, 1});
  expect_twins(file,
               "MULTAX/ON\nGOTO/0,0,0,0,0,1\nCUTCOM/LEFT,XYPLAN,5\nGOTO/1,0,0,0,0,1\nCUTCOM/OFF\nGOTO/2,0,0,0,0,1\n"
               "GOTO/3,0,0,0,0,1\nCUTCOM/RIGHT\nGOTO/4,0,0,0,0,1\nCUTCOM/OFF\nGOTO/5,0,0,0,0,1\n");
  const Toolpath path = path_of(file.bytes());
  EXPECT_FALSE(path.moves.at(1).not_checked_reason.empty());
  EXPECT_TRUE(path.moves.at(3).not_checked_reason.empty());
}

TEST(NccsCutcom, TheOffOfAdjustIsNotTheOffOfLeft) {
  NccsFile file;
  file.multax(true).points({0, 0, 0, 0, 0, 1}).post(1007, {kLeft}).post(1007, {kAdjust, kOff});
  file.points({1, 0, 0, 0, 0, 1}).points({2, 0, 0, 0, 0, 1}).post(1007, {kOff}).post(1007, {kAdjust, 1.0});
  file.points({3, 0, 0, 0, 0, 1}).points({4, 0, 0, 0, 0, 1}).post(1007, {kAdjust, kOff});
  file.points({5, 0, 0, 0, 0, 1}).points({6, 0, 0, 0, 0, 1});
  expect_twins(file,
               "MULTAX/ON\nGOTO/0,0,0,0,0,1\nCUTCOM/LEFT\nCUTCOM/ADJUST,OFF\nGOTO/1,0,0,0,0,1\nGOTO/2,0,0,0,0,1\n"
               "CUTCOM/OFF\nCUTCOM/ADJUST,1\nGOTO/3,0,0,0,0,1\nGOTO/4,0,0,0,0,1\nCUTCOM/ADJUST,OFF\nGOTO/5,0,0,0,0,1\n"
               "GOTO/6,0,0,0,0,1\n");
  const Toolpath path = path_of(file.bytes());
  EXPECT_FALSE(path.moves.at(2).not_checked_reason.empty());
  EXPECT_FALSE(path.moves.at(4).not_checked_reason.empty());
  EXPECT_TRUE(path.moves.at(6).not_checked_reason.empty());
}

TEST(NccsExpanded, IsThePlaceAndAxisOfEachPoint) {
  NccsFile file;
  file.multax(true).expanded({1, 2, 3, 0, 0, 1, 4, 5, 6, 0, 0.6, 0.8}).expanded({7, 8, 9, 0, 0, -1}, 6);
  expect_twins(file, "MULTAX/ON\nGOTO/1,2,3,0,0,1\nGOTO/4,5,6,0,.6,.8\nGOTO/7,8,9,0,0,-1\n");
  for (const Move& move : path_of(file.bytes()).moves) EXPECT_TRUE(move.not_checked_reason.empty());
}

TEST(NccsExpanded, OfAnotherFormIsNotRead) {
  const auto is_read = [](const std::vector<double>& values, std::uint16_t klass, std::uint16_t subclass) {
    NccsFile file;
    file.multax(false).points({0, 0, 0}).numbers(klass, subclass, values).points({1, 1, 1});
    const Toolpath path = path_of(file.bytes());
    return path.moves.at(1).not_checked_reason.empty();
  };
  std::vector<double> point(21, 0.0);
  point[5] = 1;
  EXPECT_TRUE(is_read(point, 5200, 5));
  EXPECT_FALSE(is_read(point, 5200, 7));
  EXPECT_FALSE(is_read(point, 5210, 5));
  EXPECT_FALSE(is_read(std::vector<double>(20, 0.5), 5200, 5));
  EXPECT_FALSE(is_read({}, 5200, 5));
  point[5] = 0.5;  // no axis
  EXPECT_FALSE(is_read(point, 5200, 5));
}

TEST(NccsCircle, FollowsFiveWordsOfItsOwn) {
  NccsFile file;
  file.multax(true).points({5, 0, 1, 0, 0, 1}).circle({0, 0, 1, 0, 0, 1, 5}).points({0, 5, 1, 0, 0, 1});
  expect_twins(file, "MULTAX/ON\nGOTO/5,0,1,0,0,1\nCIRCLE/0,0,1,0,0,1,5\nGOTO/0,5,1,0,0,1\n");
  NccsFile without;
  without.multax(true).points({5, 0, 1, 0, 0, 1}).numbers(3000, 0, {0, 0, 1, 0, 0, 1, 5}).points({0, 5, 1, 0, 0, 1});
  expect_same_moves(path_of(without.bytes()), path_of(file.bytes()));
  const Toolpath path = path_of(file.bytes());
  EXPECT_NEAR(path.arcs.at(0).sweep_rad, std::numbers::pi / 2, 1e-12);
  NccsFile other;
  other.multax(true).points({5, 0, 1, 0, 0, 1}).numbers(3000, 0, {0, 0, 1, 0, 0, 1, 5, 9}).points({0, 5, 1, 0, 0, 1});
  EXPECT_FALSE(path_of(other.bytes()).moves.at(1).not_checked_reason.empty());
}

// The vector may point either way: the sense is that of the way from point to point.
TEST(NccsCircle, IsRunTheShortWayWhateverItsVector) {
  for (const double k : {1.0, -1.0}) {
    NccsFile file;
    file.multax(false).points({5, 0, 0}).circle({0, 0, 0, 0, 0, k, 5}).points({4, 3, 0, 3, 4, 0, 0, 5, 0, -3, 4, 0}, 6);
    expect_twins(file, "MULTAX/OFF\nGOTO/5,0,0\nCIRCLE/0,0,0,0,0," + std::string(k > 0 ? "1" : "-1") +
                           ",5\nGOTO/4,3,0,3,4,0,0,5,0,-3,4,0\n");
    const Toolpath path = path_of(file.bytes());
    ASSERT_EQ(path.arcs.size(), 4u) << "a continuation goes on along the circle";
    double sweep = 0;
    for (const PathArc& arc : path.arcs) sweep += arc.sweep_rad * arc.axis.z();
    EXPECT_NEAR(sweep, std::atan2(4, -3), 1e-9);
  }
}

TEST(NccsCircle, AListMayBeginWhereTheToolStands) {
  NccsFile file;
  file.multax(false).points({5, 0, 0}).circle({0, 0, 0, 0, 0, 1, 5}).points({5, 0, 0, 3, 4, 0, 0, 5, 0});
  expect_twins(file, "MULTAX/OFF\nGOTO/5,0,0\nCIRCLE/0,0,0,0,0,1,5\nGOTO/5,0,0,3,4,0,0,5,0\n");
  const Toolpath path = path_of(file.bytes());
  EXPECT_EQ(path.arcs.size(), 2u);
  for (const Move& move : path.moves) EXPECT_TRUE(move.not_checked_reason.empty());
}

TEST(NccsCircle, HalfATurnWithoutAPointOnTheWayIsNotChecked) {
  NccsFile file;
  file.multax(false).points({5, 0, 0}).circle({0, 0, 0, 0, 0, 1, 5}).points({-5, 0, 0});
  EXPECT_FALSE(path_of(file.bytes()).moves.at(1).not_checked_reason.empty());
}

struct FrameCase {
  std::uint16_t code;
  std::vector<NccsFile::Argument> arguments;
  std::string text;
  bool is_checked;
};

TEST(NccsFrame, WhatMayShiftOrTurnMakesWhatFollowsNotChecked) {
  const std::vector<FrameCase> cases = {
      {1037, {1.0, 0.0, 0.0}, "TRANS/1,0,0", false},
      {1037, {0.0, 0.0, 0.0}, "TRANS/0,0,0", true},
      {1027, {1.0, 2.0, 3.0}, "ORIGIN/1,2,3", false},
      {1026, {Minor{1}, 90.0}, "ROTABL/ATANGL,90", false},
      {1026, {Minor{1}, 0.0}, "ROTABL/ATANGL,0", true},
      {1035, {Minor{1}, 45.0}, "ROTHED/ATANGL,45", false},
      {1038, {0.0}, "TRACUT/0", false},
      {812, {0.0}, "TRACUT/0", false},
      {1040, {1.0}, "COPY/1", false},
      {811, {1.0}, "COPY/1", false},
      {1049, {1.5, 3.0}, "COUPLE/1.5,3", false},
      {1008, {Minor{84}}, "REVERS/XAXIS", false},
      {1024, {Minor{84}, 1.0}, "POSITN/XAXIS,1", false},
      {7, {}, "RETRCT", false},
      {1014, {}, "GOHOME", true},
      {14, {}, "GOHOME", true},
      {1058, {3.0}, "DWELL/3", true},
      {1030, {kOn}, "COOLNT/ON", true},
      {1234, {1.0, 2.0}, "STRANGE/1,2", false},
      {1234, {1.0, 2.0, 3.0}, "STRANGE/1,2,3", false},
      {1234, std::vector<NccsFile::Argument>(9, 1.0), "STRANGE/1,1,1,1,1,1,1,1,1", false}};
  for (const FrameCase& c : cases) {
    SCOPED_TRACE(c.text);
    NccsFile file;
    file.multax(false).points({0, 0, 0}).post(c.code, c.arguments).points({1, 1, 1}).points({2, 1, 1});
    expect_twins(file, "MULTAX/OFF\nGOTO/0,0,0\n" + c.text + "\nGOTO/1,1,1\nGOTO/2,1,1\n");
    const Toolpath path = path_of(file.bytes());
    EXPECT_EQ(path.moves.at(1).not_checked_reason.empty(), c.is_checked);
  }
}

TEST(NccsFrame, ZerosUndoOnlyTheirOwnWordsShift) {
  const auto last_is_checked = [](const std::string& text) {
    return text_of("MULTAX/OFF\nGOTO/0,0,0\n" + text + "GOTO/1,1,1\nGOTO/2,1,1\n")
        .moves.back()
        .not_checked_reason.empty();
  };
  EXPECT_TRUE(last_is_checked("TRANS/1,0,0\nTRANS/0,0,0\n"));
  EXPECT_FALSE(last_is_checked("ORIGIN/1,0,0\nTRANS/0,0,0\n"));
  EXPECT_FALSE(last_is_checked("TRANS/1,0,0\nTRANS/INCR,0,0,0\n"));
  EXPECT_FALSE(last_is_checked("ROTABL/ATANGL,90\nROTABL/ATANGL,-90\n"));
}

TEST(NccsCircle, ThatLeavesItsPlaneOrTurnsTheToolIsNotChecked) {
  const auto is_checked = [](const std::vector<double>& end) {
    NccsFile file;
    file.multax(true).points({5, 0, 0, 0, 0, 1}).circle({0, 0, 0, 0, 0, 1, 5}).points(end);
    return path_of(file.bytes()).moves.at(1).not_checked_reason.empty();
  };
  EXPECT_TRUE(is_checked({0, 5, 0, 0, 0, 1}));
  EXPECT_FALSE(is_checked({0, 5, 1, 0, 0, 1}));
  EXPECT_FALSE(is_checked({0, 5, 0, 0, 0.6, 0.8}));
}

TEST(NccsText, AFileThatIsIncludedIsAMotionThatIsNotRead) {
  NccsFile file;
  file.multax(false).points({0, 0, 0}).record(2000, 1044, "INCLUD OTHER.CL ").points({1, 1, 1}).points({2, 1, 1});
  expect_twins(file, "MULTAX/OFF\nGOTO/0,0,0\nPPRINT INCLUD OTHER.CL\nGOTO/1,1,1\nGOTO/2,1,1\n");
  const Toolpath path = path_of(file.bytes());
  ASSERT_EQ(path.moves.size(), 4u);
  EXPECT_FALSE(path.moves[1].not_checked_reason.empty());
  EXPECT_FALSE(path.moves[2].has_start);
}

TEST(NccsExpanded, WithoutMultaxAnotherAxisThanPlusZIsNotRead) {
  for (const bool is_on : {true, false}) {
    NccsFile file;
    file.multax(is_on).expanded({1, 2, 3, 0, 0, 1}).expanded({1, 2, 3, 0, 0.6, 0.8});
    const Toolpath path = path_of(file.bytes());
    EXPECT_TRUE(path.moves.at(0).not_checked_reason.empty());
    EXPECT_EQ(path.moves.at(1).not_checked_reason.empty(), is_on);
  }
}

TEST(NccsMode, TheFirstOfTheTwoIsMultaxOnAsInTheRealTwins) {
  NccsFile file;
  file.record(9000, 0).points({1, 2, 3, 0, 0.6, 0.8}).record(9000, 1).points({1, 2, 3, 4, 5, 6});
  const Toolpath path = path_of(file.bytes());
  ASSERT_EQ(path.moves.size(), 3u);
  expect_vector(path.moves[0].end.axis, 0, 0.6, 0.8);
  expect_vector(path.moves[2].end.tip, 4, 5, 6);
}

TEST(NccsRecords, ALongSequenceNumberStandsInARecordOfItsOwn) {
  NccsFile file;
  file.multax(false).points({1, 2, 3}).record(1001, 0x1234).points({4, 5, 6});
  const Toolpath path = path_of(file.bytes());
  ASSERT_EQ(path.moves.size(), 2u);
  EXPECT_TRUE(path.moves[1].not_checked_reason.empty());
  EXPECT_TRUE(path.words_not_understood.empty());
}

// Its word stands in no text of the file.
TEST(NccsRecords, LetteringIsText) {
  for (const char* text : {"DEPTH 5 ", "/1,2    ", "        "}) {
    NccsFile file;
    file.multax(false).points({1, 2, 3}).record(2000, 1043, text).points({4, 5, 6});
    const Toolpath path = path_of(file.bytes());
    ASSERT_GE(path.moves.size(), 2u) << text;
    EXPECT_EQ(path.moves.back().not_checked_reason.empty(), text[0] != '/') << text;
  }
}

// tests/corpus/cl/nccs_words.cl is these records: a seed for the fuzzers that has every kind of them.
TEST(NccsRecords, OfTheSampleAreThese) {
  NccsFile file;
  file.multax(true).record(2000, 1015, "PWORKS  ").record(2000, 1044, "POCKET  ").post(1055, {1.0});
  file.numbers(6000, 6, {6, 1, 40}).post(1009, {kMmpm, 250.0}).post(5).points({5, 0, 9, 0, 0, 1});
  file.points({5, 0, 1, 0, 0, 1}).circle({0, 0, 1, 0, 0, 1, 5});
  file.points({4, 3, 1, 0, 0, 1, 0, 5, 1, 0, 0, 1, -4, 3, 1, 0, 0, 1}, 12).points({-4, 9, 1, 0, 0, 1});
  file.expanded({-4, 9, 2, 0, 0, 1, -4, 9, 3, 0, 0.6, 0.8}).expanded({-4, 9, 4, 0, 0.6, 0.8}, 6);
  file.post(1007, {kLeft, Minor{33}, 5.0}).points({0, 9, 4, 0, 0, 1}).post(1007, {kOff}).points({1, 9, 4, 0, 0, 1});
  file.record(1001, 0x1234).points({2, 9, 9, 0, 0, 1}).points({3, 9, 9, 0, 0, 1});
  file.post(1054, {kDrill, kFedto, 12.5, kMmpm, 80.0, kRapto, 2.0, kRtrcto, 8.0});
  file.points({10, 9, 0, 0, 0, 1, 20, 9, 0, 0, 0, 1}).post(1054, {kOff}).points({20, 9, 50, 0, 0, 1}).post(14);
  const auto sample = corpus() / "nccs_words.cl";
  if (std::getenv("GOUGE_UPDATE_SAMPLES") != nullptr) {
    std::ofstream(sample, std::ios::binary) << file.bytes();
  }
  EXPECT_TRUE(bytes_of(sample) == file.bytes());
  const Toolpath path = path_of(file.bytes());
  EXPECT_EQ(path.arcs.size(), 3u);
  const auto unchecked = std::count_if(path.moves.begin(), path.moves.end(),
                                       [](const Move& move) { return !move.not_checked_reason.empty(); });
  EXPECT_EQ(unchecked, 2) << "the one under CUTCOM and the first after it";
}

TEST(NccsRecords, AWordAmongTheNumbersOfAMotionIsRefused) {
  const std::string word = nccs_word(NccsHeader{163, 0, 0, 0});
  NccsFile file;
  file.multax(false).record(5000, 5, nccs_word(1.0) + word + nccs_word(2.0));
  const ReadOutcome outcome = read_toolpath("a.cl", file.bytes());
  ASSERT_FALSE(outcome.toolpath);
  EXPECT_EQ(outcome.errors.front().code, "path-number");
}

}  // namespace
}  // namespace gouge::nccs_records_test
