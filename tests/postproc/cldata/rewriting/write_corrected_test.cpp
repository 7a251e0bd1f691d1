#include "postproc/formats/write_corrected.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/postproc/cldata/corrected.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::write_corrected_test {
namespace {

TEST(WriteCorrected, ChangesOnlyTheNumberThatChanged) {
  const Toolpath path =
      path_of("UNITS/MM\r\nGOTO/1.000000, 2.000000, 3.000000\r\nGOTO/1.500000, -0.000000, 3.000000\r\nFINI\r\n");
  EXPECT_EQ(written(path, {lift(path, 1, 0.25)}),
            "UNITS/MM\r\nGOTO/1.000000, 2.000000, 3.000000\r\nGOTO/1.500000, -0.000000, 3.250000\r\nFINI\r\n");
}

TEST(WriteCorrected, DropsZerosWhereTheFileDoes) {
  const Toolpath path = path_of("GOTO/25.,0,.647402\nGOTO/-0.142874,1.5,-2.\nGOTO/1.,1.,1.\n");
  EXPECT_EQ(written(path, {lift(path, 0, -0.647402), lift(path, 1, 1.9), lift(path, 2, -0.5)}),
            "GOTO/25.,0,0\nGOTO/-0.142874,1.5,-0.1\nGOTO/1.,1.,.5\n");
}

TEST(WriteCorrected, KeepsColumnsWhereTheFileHasThem) {
  const Toolpath path = path_of(
      "MULTAX\nGOTO  /   98.00000,  100.00000,   -9.50000, 0.000000, 0.000000, 1.000000\n"
      "GOTO  /    8.00000, -100.00000,    9.00000,-1.000000, 0.000000, 0.000000\n");
  EXPECT_EQ(written(path, {lift(path, 0, 19.25)}),
            "MULTAX\nGOTO  /   98.00000,  100.00000,    9.75000, 0.000000, 0.000000, 1.000000\n"
            "GOTO  /    8.00000, -100.00000,    9.00000,-1.000000, 0.000000, 0.000000\n");
}

TEST(WriteCorrected, AFeedBecomesARapidWithAWordOfItsOwn) {
  const Toolpath path = path_of("FEDRAT/100,MMPM\nGOTO/1.,2.,3.\nGOTO/4.,5.,6.\nGOTO/7.,8.,9.\n");
  PathChange change = lift(path, 1, 10);
  change.inserted_before = {{Vec3(1, 2, 13), Vec3::UnitZ()}, {Vec3(2, 3, 15), Vec3::UnitZ()}};
  change.at_rapid = {false, true, true};
  const std::string text = written(path, {change});
  EXPECT_EQ(text,
            "FEDRAT/100,MMPM\nGOTO/1.,2.,3.\nGOTO/1.,2.,13.\nRAPID\nGOTO/2.,3.,15.\nRAPID\nGOTO/4.,5.,16.\n"
            "GOTO/7.,8.,9.\n");
  const Toolpath again = path_of(text);
  ASSERT_EQ(again.moves.size(), 5U);
  EXPECT_EQ(again.moves[1].kind, MoveKind::feed);
  EXPECT_EQ(again.moves[2].kind, MoveKind::rapid);
  EXPECT_EQ(again.moves[3].kind, MoveKind::rapid);
  EXPECT_EQ(again.moves[4].kind, MoveKind::feed);
  EXPECT_DOUBLE_EQ(again.moves[4].feed_mm, 100);
}

TEST(WriteCorrected, EntriesOfWhatIsARapidAreOneForEachPositionOfAFeed) {
  const Toolpath path = path_of("GOTO/1.,2.,3.\nGOTO/4.,5.,6.\nRAPID\nGOTO/7.,8.,9.\n");
  PathChange change = lift(path, 1, 10);
  change.at_rapid = {true, true};
  const Result<std::string> two = write_corrected(path, {change});
  ASSERT_FALSE(two);
  EXPECT_NE(two.error().message.find("2 entries of what is reached at rapid for 0 inserted positions"),
            std::string::npos);
  PathChange rapid = lift(path, 2, 10);
  rapid.at_rapid = {true};
  const Result<std::string> of_rapid = write_corrected(path, {rapid});
  ASSERT_FALSE(of_rapid);
  EXPECT_NE(of_rapid.error().message.find("only of a feed"), std::string::npos);
}

// Behind it a position of three numbers would be in doubt.
TEST(WriteCorrected, FramesAnAxisInAFileThatHasNone) {
  const Toolpath path = path_of("UNITS/MM\nGOTO/1.0,2.0,3.0\nGOTO/4.0,5.0,6.0\nGOTO/7.0,8.0,9.0\nFINI\n");
  const Vec3 axis(0.6, 0, 0.8);
  EXPECT_EQ(
      written(path, {{1, Pose{Vec3(4, 5, 7), axis}, {}, false}}),
      "UNITS/MM\nGOTO/1.0,2.0,3.0\nMULTAX/ON\nGOTO/4.0,5.0,7.0000,0.600000000,0.000000000,0.800000000\nMULTAX/OFF\n"
      "MULTAX/ON\nGOTO/7.0,8.0,9.0,0.000000000,0.000000000,1.000000000\nMULTAX/OFF\nFINI\n");
}

TEST(WriteCorrected, WritesEnoughDecimalsForACorrection) {
  const Toolpath path = path_of("GOTO/1,2,3\nGOTO/4,5,6\n");
  EXPECT_EQ(written(path, {lift(path, 1, 0.0123)}), "GOTO/1,2,3\nGOTO/4,5,6.0123\n");
}

TEST(WriteCorrected, ContinuedStatementsStayContinued) {
  const Toolpath path =
      path_of("MULTAX\nGOTO / 1.0000, 2.0000, 3.0000,  $\n0.0000000000, 1.0000000000, 0.0000000000\n");
  EXPECT_EQ(written(path, {lift(path, 0, 1)}),
            "MULTAX\nGOTO / 1.0000, 2.0000, 4.0000,  $\n0.0000000000, 1.0000000000, 0.0000000000\n");
}

TEST(WriteCorrected, NumbersLabelsAndCommentsOfStatementsStay) {
  const std::string text =
      "\xef\xbb\xbfN10 UNITS/MM\nN20 CUT COM/OFF\nN30 GOTO/1.,2.,$ Z FOLLOWS\n3.\nLAB1) GOTO/1.D0,5.,6.\nFINI\n";
  const Toolpath path = path_of(text);
  EXPECT_EQ(written(path, {}), text);
  PathChange change = lift(path, 1, 1.5);
  change.inserted_before.push_back(lift(path, 0, 2).new_end.value());
  EXPECT_EQ(written(path, {change}),
            "\xef\xbb\xbfN10 UNITS/MM\nN20 CUT COM/OFF\nN30 GOTO/1.,2.,$ Z FOLLOWS\n3.\n"
            "GOTO/1.,2.,5.\nLAB1) GOTO/1.D0,5.,7.5\nFINI\n");
  const Toolpath rapid = path_of("N1 GOTO/1.,2.,3.\nN2 RAPID\nN3 GOTO/4.,5.,6.\nFINI\n");
  EXPECT_EQ(written(rapid, {{1, std::nullopt, {{Vec3(1, 2, 9), Vec3::UnitZ()}}, false}}),
            "N1 GOTO/1.,2.,3.\nN2 RAPID\nGOTO/1.,2.,9.\nRAPID\nN3 GOTO/4.,5.,6.\nFINI\n");
}

TEST(WriteCorrected, EveryPieceOfARapidStaysRapid) {
  const Toolpath path =
      path_of("GOTO/0.0000,0.0000,9.0000\nRAPID/\nGOTO/9.0000,0.0000,9.0000\nGOTO/9.0000,0.0000,1.0000\n");
  const PathChange change{1, std::nullopt, {{Vec3(0, 0, 20), Vec3::UnitZ()}, {Vec3(9, 0, 20), Vec3::UnitZ()}}};
  const std::string text = written(path, {change});
  EXPECT_EQ(
      text,
      "GOTO/0.0000,0.0000,9.0000\nRAPID/\nGOTO/0.0000,0.0000,20.0000\nRAPID/\nGOTO/9.0000,0.0000,20.0000\nRAPID/\n"
      "GOTO/9.0000,0.0000,9.0000\nGOTO/9.0000,0.0000,1.0000\n");
  const Toolpath again = path_of(text);
  ASSERT_EQ(again.moves.size(), 5u);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(again.moves[i].kind, MoveKind::rapid);
  EXPECT_EQ(again.moves[4].kind, MoveKind::feed);
}

TEST(WriteCorrected, InsertsBeforeALastLineWithoutLineEnd) {
  const Toolpath path = path_of("GOTO/0.0000,0.0000,9.0000\nGOTO/9.0000,0.0000,9.0000");
  EXPECT_EQ(written(path, {{1, std::nullopt, {{Vec3(1, 2, 3), Vec3::UnitZ()}}}}),
            "GOTO/0.0000,0.0000,9.0000\nGOTO/1.0000,2.0000,3.0000\nGOTO/9.0000,0.0000,9.0000");
}

// In a dialect that states what a position without axis means; else it would be in doubt behind a tilted one.
TEST(WriteCorrected, AnAxisThatThreeNumbersDoNotMeanIsWritten) {
  const std::string start = "$$* Pro/CLfile\nMULTAX/ON\nGOTO/0.0000,0.0000,9.0000,1.0000000,0.0000000,0.0000000\n";
  const Toolpath path = path_of(start + "GOTO/9.0000,0.0000,9.0000\n");
  const double s = std::sqrt(0.5);
  EXPECT_EQ(written(path, {{1, std::nullopt, {{Vec3(1, 2, 3), Vec3(s, 0, s)}}}}),
            start + "GOTO/1.0000,2.0000,3.0000,0.7071068,0.0000000,0.7071068\nGOTO/9.0000,0.0000,9.0000\n");
}

TEST(WriteCorrected, UnderMultaxOffAnAxisSwitchesItOn) {
  const Toolpath path = path_of(
      "$$* Pro/CLfile\nMULTAX/ON\nGOTO/0.0000,0.0000,9.0000,1.0000000,0.0000000,0.0000000\nMULTAX/OFF\n"
      "GOTO/9.0000,0.0000,9.0000\n");
  const double s = std::sqrt(0.5);
  const std::string text = written(path, {{1, std::nullopt, {{Vec3(1, 2, 3), Vec3(s, 0, s)}}}});
  EXPECT_NE(text.find("MULTAX/OFF\nMULTAX/ON\nGOTO/1.0000,2.0000,3.0000,0.7071068,0.0000000,0.7071068\nMULTAX/OFF\n"
                      "GOTO/9.0000,0.0000,9.0000\n"),
            std::string::npos)
      << text;
}

// The file does not state which axis it has.
TEST(WriteCorrected, APositionWithoutAxisBehindATiltedOneCannotBeChanged) {
  const Toolpath path = path_of("GOTO/0.,0.,9.,1.,0.,0.\nGOTO/9.,0.,9.\n");
  EXPECT_EQ(write_corrected(path, {lift(path, 1, 1)}).error().code, "write-move");
}

constexpr const char* kBlock =
    "TOOL PATH/A,TOOL,B\nMSYS/100.0000,0.0000,0.0000,0.0000000,1.0000000,0.0000000,1.0000000,0.0000000,0.0000000\n"
    "GOTO/1.0000,2.0000,3.0000,0.0000000,0.0000000,-1.0000000\nGOTO/1.0000,2.0000,4.0000\nGOTO/"
    "1.0000,2.0000,5.0000\nEND-OF-PATH\n";

TEST(WriteCorrected, GoesBackToTheFrameOfTheBlock) {
  const Toolpath path = path_of(kBlock);
  const std::string text = written(path, {lift(path, 1, 0.5)});
  EXPECT_NE(text.find("GOTO/1.0000,2.0000,3.5000\n"), std::string::npos) << text;
  EXPECT_NEAR((path_of(text).moves[1].end.tip - path.moves[1].end.tip).z(), 0.5, 1e-12);
}

TEST(WriteCorrected, AModalAxisIsRestatedForStatementsThatRelyOnIt) {
  const Toolpath path = path_of(kBlock);
  const double s = std::sqrt(0.5);
  Pose tilted = path.moves[1].end;
  tilted.axis = Vec3(s, 0, s);
  const std::string text = written(path, {{1, tilted, {}}});
  const Toolpath again = path_of(text);
  ASSERT_EQ(again.moves.size(), 3u);
  EXPECT_LT((again.moves[1].end.axis - tilted.axis).norm(), 1e-6);
  EXPECT_LT((again.moves[2].end.axis - path.moves[2].end.axis).norm(), 1e-12);
  EXPECT_NE(text.find("GOTO/1.0000,2.0000,5.0000,0.0000000,0.0000000,-1.0000000\n"), std::string::npos) << text;
}

TEST(WriteCorrected, APositionInsertedBeforeAnAxisOfItsOwnChangesNothingAfterIt) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nGOTO/0.0000,0.0000,0.0000\nGOTO/1.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000\n"
      "GOTO/2.0000,0.0000,0.0000\nEND-OF-PATH\n");
  const double s = std::sqrt(0.5);
  EXPECT_EQ(written(path, {{1, std::nullopt, {{Vec3(0.5, 0, 3), Vec3(s, 0, s)}}}}),
            "TOOL PATH/A,TOOL,B\nGOTO/0.0000,0.0000,0.0000\nGOTO/0.5000,0.0000,3.0000,0.7071068,0.0000000,0.7071068\n"
            "GOTO/1.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000\nGOTO/2.0000,0.0000,0.0000\nEND-OF-PATH\n");
}

TEST(WriteCorrected, AStatementOfSeveralPositionsIsSplitOnlyToInsert) {
  const Toolpath path = path_of("RAPID\nGOTO/1.0000,2.0000,3.0000,4.0000,5.0000,6.0000,7.0000,8.0000,9.0000\n");
  EXPECT_EQ(written(path, {lift(path, 1, 0.5)}),
            "RAPID\nGOTO/1.0000,2.0000,3.0000,4.0000,5.0000,6.5000,7.0000,8.0000,9.0000\n");
  EXPECT_EQ(written(path, {{1, std::nullopt, {{Vec3(0, 0, 20), Vec3::UnitZ()}}}}),
            "RAPID\nGOTO/1.0000,2.0000,3.0000\nGOTO/0.0000,0.0000,20.0000\nGOTO/4.0000,5.0000,6.0000\nGOTO/"
            "7.0000,8.0000,9.0000\n");
}

TEST(WriteCorrected, IncrementsBecomePositionsWhereTheirStartMoved) {
  const Toolpath path =
      path_of("GOTO/1.0000,2.0000,3.0000\nGODLTA/0.0000,0.0000,1.0000\nGODLTA/0.0000,0.0000,1.0000\n");
  EXPECT_EQ(written(path, {lift(path, 0, 0.5)}),
            "GOTO/1.0000,2.0000,3.5000\nGOTO/1.0000,2.0000,4.0000\nGODLTA/0.0000,0.0000,1.0000\n");
}

TEST(WriteCorrected, AHoleThatIsAStepFromWhatChangesIsAnError) {
  const std::string text = "UNITS/MM\nGOTO/1,2,9\nCYCLE/DRILL,FEDTO,2,RAPTO,1\n";
  const Toolpath by_step = path_of(text + "GODLTA/0,5,0\n");
  const Toolpath by_position = path_of(text + "GOTO/1,7,9\n");
  EXPECT_EQ(by_step.moves.back().end.tip, by_position.moves.back().end.tip);
  EXPECT_EQ(write_corrected(by_step, {lift(by_step, 0, 0.5)}).error().code, "write-arc");
  EXPECT_TRUE(write_corrected(by_position, {lift(by_position, 0, 0.5)}).has_value());
}

TEST(WriteCorrected, InchFilesStayInInches) {
  const Toolpath path = path_of("UNITS/INCHES\nGOTO/1.000000, 2.000000, 3.000000\n");
  EXPECT_EQ(written(path, {lift(path, 0, 2.54)}), "UNITS/INCHES\nGOTO/1.000000, 2.000000, 3.100000\n");
}

TEST(WriteCorrected, WhatCannotBeChangedIsAnError) {
  const Toolpath path = path_of("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\nGOTO/5,5,5\n");
  EXPECT_EQ(to_text(write_corrected(path, {lift(path, 1, 1)}).error()),
            "test.apt:3: error: move 1 is an arc, a curve or a cycle; only straight moves can be changed [write-arc]");
  EXPECT_EQ(write_corrected(path, {{0, std::nullopt, {Pose{}}}}).error().code, "write-alone");
  EXPECT_EQ(write_corrected(path, {{9, Pose{}, {}}}).error().message,
            "move 9 is not in the path; expected one change for a move of the path");
  EXPECT_EQ(write_corrected(path, {lift(path, 0, 1), lift(path, 0, 2)}).error().message,
            "move 0 is named twice; expected one change for a move of the path");
}

TEST(WriteCorrected, RefusesToChangeMovesThatCopyRepeats) {
  const Toolpath path = path_of(
      "$$ CATIA APT VERSION 1.0\nGOTO/0,0,9\nINDEX/1\nGOTO/1,0,9\nGOTO/2,0,9\nINDEX/1,NOMORE\n"
      "COPY/1,TRANSL,0,10,0,2\nGOTO/3,0,9\nFINI\n");
  ASSERT_EQ(path.moves.size(), 8u);
  for (const std::size_t copied : {3u, 4u, 5u, 6u}) {
    const Result<std::string> text = write_corrected(path, {lift(path, copied, 1)});
    ASSERT_FALSE(text.has_value()) << copied;
    EXPECT_EQ(text.error().code, "write-move");
    EXPECT_EQ(text.error().line, 7u);
  }
  EXPECT_TRUE(write_corrected(path, {lift(path, 7, 1)}).has_value()) << "the move after them has a position of its own";
}

}  // namespace
}  // namespace gouge::write_corrected_test
