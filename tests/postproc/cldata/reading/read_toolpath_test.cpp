#include "postproc/formats/read_toolpath.h"

#include <gtest/gtest.h>

#include "tests/postproc/cldata/path_of.h"

namespace gouge::read_toolpath_test {
namespace {

std::vector<MoveKind> kinds(const Toolpath& path) {
  std::vector<MoveKind> result;
  for (const Move& move : path.moves) result.push_back(move.kind);
  return result;
}

using Kinds = std::vector<MoveKind>;

TEST(ReadApt, RapidHoldsForOneMotionInEverySpelling) {
  const Toolpath path = path_of("RAPID\nGOTO/0,0,9\nGOTO/0,0,8\nRAPID/\nGOTO/0,0,7\nRAPID \nGOTO/0,0,6\nGOTO/0,0,5\n");
  EXPECT_EQ(kinds(path), (Kinds{MoveKind::rapid, MoveKind::feed, MoveKind::rapid, MoveKind::rapid, MoveKind::feed}));
  EXPECT_EQ(path.moves[1].line, 3u);
  ASSERT_TRUE(path.moves[4].has_start);
  expect_vector(path.start_of(4).tip, 0, 0, 6);
  EXPECT_FALSE(path.moves[0].has_start);
}

TEST(ReadApt, AFeedAfterRapidCancelsIt) {
  EXPECT_EQ(kinds(path_of("RAPID\nFEDRAT/100\nGOTO/0,0,9\n")), (Kinds{MoveKind::feed}));
}

TEST(ReadApt, FeedComesInBothOrdersAndUnits) {
  const Toolpath path = path_of(
      "UNITS/MM\nFEDRAT/MMPM,250\nGOTO/0,0,1\nFEDRAT/ 10.0,IPM\nGOTO/0,0,2\nFEDRAT/0.1,MMPR\nGOTO/0,0,3\nUNITS/INCHES\n"
      "FEDRAT/2,PERMIN\nGOTO/0,0,4\nRAPID\nGOTO/0,0,5\nFEDRAT/2\nGOTO/0,0,6\n");
  EXPECT_DOUBLE_EQ(path.moves[0].feed_mm, 250);
  EXPECT_DOUBLE_EQ(path.moves[1].feed_mm, 254);
  EXPECT_DOUBLE_EQ(path.moves[2].feed_mm, 0.1);
  EXPECT_DOUBLE_EQ(path.moves[3].feed_mm, 50.8);
  std::vector<FeedUnit> units;
  for (const Move& move : path.moves) units.push_back(move.feed_unit);
  EXPECT_EQ(units, (std::vector<FeedUnit>{FeedUnit::per_minute, FeedUnit::per_minute, FeedUnit::per_revolution,
                                          FeedUnit::per_minute, FeedUnit::rapid, FeedUnit::not_understood}));
}

TEST(ReadApt, ThreeNumbersMeanUpwardsAndNotTheLastAxis) {
  const Toolpath path = path_of("GOTO/1,2,3,1,0,0\nGOTO/4,5,6\nTLAXIS/0,1,0\nGOTO/7,8,9\n");
  expect_vector(path.moves[0].end.axis, 1, 0, 0);
  expect_vector(path.moves[1].end.axis, 0, 0, 1);
  expect_vector(path.moves[2].end.axis, 0, 1, 0);
  bool is_reported = false;
  for (const Diagnostic& note : path.notes) is_reported = is_reported || note.code == "path-plain-axis";
  EXPECT_TRUE(is_reported);
}

TEST(ReadApt, SixNumbersAreTwoPositionsOnlyUnderMultaxOff) {
  const Toolpath path =
      path_of("MULTAX/OFF\nGOTO/1,2,3,4,5,6\nMULTAX\nGOTO/7,8,9,0,0,-1\nGOTO/0,0,0,0,0,1,1,1,1,1,0,0\n");
  ASSERT_EQ(path.moves.size(), 5u);
  expect_vector(path.moves[1].end.tip, 4, 5, 6);
  EXPECT_EQ(path.moves[1].statement, path.moves[0].statement);
  expect_vector(path.moves[2].end.axis, 0, 0, -1);
  expect_vector(path.moves[4].end.tip, 1, 1, 1);
  expect_vector(path.moves[4].end.axis, 1, 0, 0);
}

TEST(ReadApt, NineNumbersAreThreePositions) { EXPECT_EQ(path_of("GOTO/1,2,3,4,5,6,7,8,9\n").moves.size(), 3u); }

TEST(ReadApt, InchesBecomeMillimetresAlsoWhereTheUnitChanges) {
  const Toolpath path = path_of("UNITS/INCHES\nCUTTER/0.5\nGOTO/1,0,0\nUNITS/MM\nGOTO/1,0,0\n");
  EXPECT_EQ(path.unit, LengthUnit::inch);
  EXPECT_TRUE(path.is_unit_stated);
  EXPECT_DOUBLE_EQ(path.moves[0].end.tip.x(), 25.4);
  EXPECT_DOUBLE_EQ(path.moves[1].end.tip.x(), 1);
  EXPECT_DOUBLE_EQ(path.tools.at(0).cutter->d_mm, 12.7);
}

TEST(ReadApt, TheUnitIsGuessedFromTheFeedWord) {
  const Toolpath path = path_of("RAPID\nGOTO/1,0,0\nFEDRAT/10,IPM\nGOTO/2,0,0\n");
  EXPECT_EQ(path.unit, LengthUnit::inch);
  EXPECT_FALSE(path.is_unit_stated);
  EXPECT_DOUBLE_EQ(path.moves[0].end.tip.x(), 25.4);
}

TEST(ReadApt, FromIsAPlaceAndNotACut) {
  const Toolpath path = path_of("FROM/1,2,3\nLOADTL/4\nGOTO/1,2,9\n");
  EXPECT_EQ(kinds(path), (Kinds{MoveKind::rapid, MoveKind::feed}));
  EXPECT_FALSE(path.moves[0].has_start);
  ASSERT_TRUE(path.moves[1].has_start);
  expect_vector(path.start_of(1).tip, 1, 2, 3);
  EXPECT_EQ(path.moves[0].tool, path.moves[1].tool);
}

TEST(ReadApt, GodltaMovesOnAndGohomeMayHaveAPlace) {
  const Toolpath path =
      path_of("GOTO/1,2,3,1,0,0\nGODLTA/1,1,1\nGODLTA/5\nGOHOME/0,0,50,1,0,0\nGOTO/1,1,1,1,0,0\nGOHOME\nGOTO/0,0,0\n");
  expect_vector(path.moves[1].end.tip, 2, 3, 4);
  expect_vector(path.moves[2].end.tip, 7, 3, 4);
  expect_vector(path.moves[2].end.axis, 1, 0, 0);
  EXPECT_EQ(path.moves[3].kind, MoveKind::rapid);
  EXPECT_TRUE(path.moves[4].has_start);
  EXPECT_FALSE(path.moves[5].has_start);
}

TEST(ReadApt, AnotherToolBreaksTheMotionAndTheSameOneDoesNot) {
  const Toolpath path = path_of(
      "CUTTER/10\nLOADTL/1\nGOTO/0,0,1\nLOADTL/1,1\nGOTO/0,0,2\nCUTTER/6\nLOADTL/2\nGOTO/0,0,3\nLOADTL/1\nGOTO/"
      "0,0,4\n");
  ASSERT_EQ(path.tools.size(), 2u);
  EXPECT_TRUE(path.moves[1].has_start);
  EXPECT_FALSE(path.moves[2].has_start);
  EXPECT_FALSE(path.moves[3].has_start);
  EXPECT_EQ(path.moves[3].tool, 0u);
  EXPECT_DOUBLE_EQ(path.tools[path.moves[3].tool].cutter->d_mm, 10);
}

TEST(ReadApt, AToolTheFileDoesNotDescribeDoesNotInheritTheOldCutter) {
  const Toolpath path = path_of("CUTTER/10\nLOADTL/1\nGOTO/0,0,1\nLOADTL/2\nGOTO/0,0,2\n");
  EXPECT_FALSE(path.tools.at(path.moves[1].tool).cutter);
  EXPECT_EQ(path.tools.at(path.moves[1].tool).number, 2);
}

TEST(ReadApt, SelectOnlyAnnouncesATool) {
  const Toolpath path = path_of("CUTTER/8\nLOAD/TOOL,3\nSELECT/TOOL,5\nGOTO/0,0,1\n");
  EXPECT_EQ(path.tools.at(0).number, 3);
}

TEST(ReadApt, AnArcOfNoKnownSenseHasAnEndAndIsCoveredByItsCircle) {
  const Toolpath path = path_of("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1,0\nGOTO/0,2,0\n");
  EXPECT_TRUE(path.moves[1].is_covered());
  EXPECT_EQ(path.moves[1].kind, MoveKind::arc);
  EXPECT_EQ(path.moves[1].not_checked_reason, "nothing in the file states which way round its arcs run");
  ASSERT_TRUE(path.moves[2].has_start);
  expect_vector(path.start_of(2).tip, 0, 1, 0);
  EXPECT_TRUE(path.moves[2].not_checked_reason.empty());
}

TEST(ReadApt, CurvesOfOtherKindsAreNotTakenAsStraight) {
  const Toolpath path = path_of("GOTO/1,0,0\nSPLINE/3\nGOTO/0,1,0\nGOTO/0,2,0\n");
  EXPECT_FALSE(path.moves[1].not_checked_reason.empty());
  EXPECT_TRUE(path.moves[2].not_checked_reason.empty());
}

TEST(ReadApt, ASplineThatIsSwitchedOnIsNotCheckedUntilItIsSwitchedOff) {
  const Toolpath path = path_of("GOTO/1,0,0\nSPLINE/ON\nGOTO/0,1,0\nGOTO/0,2,0\nSPLINE/OFF\nGOTO/0,3,0\nGOTO/0,4,0\n");
  std::string checked;
  for (const Move& move : path.moves) checked += move.not_checked_reason.empty() ? '1' : '0';
  EXPECT_EQ(checked,
            "100"
            "0"
            "1");
}

std::string checked_moves(const std::string& text, const char* dialect) {
  ReadOptions options;
  options.dialect = dialect_called(dialect);
  const ReadOutcome outcome = read_toolpath("test", text, options);
  std::string checked;
  if (!outcome.toolpath) return to_text(outcome.errors.front());
  for (const Move& move : outcome.toolpath->moves) checked += move.not_checked_reason.empty() ? '1' : '0';
  return checked;
}

TEST(ReadApt, SixNumbersThatMayBeTwoPositionsAreNotChecked) {
  const std::string two = "GOTO/0,0,40,0.98995,0,-0.141421\nGOTO/0,0,60\nGOTO/0,0,70\n";
  EXPECT_EQ(checked_moves("GOTO/0,0,60\n" + two, "apt"), "1100") << "the last ones may be tilted";
  EXPECT_EQ(checked_moves("MULTAX/ON\nGOTO/0,0,60,0,0,1\nGOTO/0,0,40,0.98995,0,-0.141421\n", "apt"), "11");
  for (const char* dialect : {"apt", "apt-creo", "apt-nccs", "apt-catia"})
    EXPECT_EQ(checked_moves("MULTAX/OFF\nGOTO/0,0,60\n" + two, dialect), "1001") << dialect;
  EXPECT_EQ(checked_moves("GOTO/0,0,60\n" + two, "apt-creo"), "1001");
  EXPECT_EQ(checked_moves("GOTO/0,0,60\nGOTO/0,0,40,8,0,2\n", "apt-creo"), "111") << "no axis has that length";
}

TEST(ReadApt, APlainPositionAfterATiltedOneIsNotChecked) {
  const std::string text = "GOTO/0,0,9,1,0,0\nGOTO/0,0,8\nGOTO/0,0,7\nGOTO/0,0,6,0,0,1\nGOTO/0,0,5\n";
  EXPECT_EQ(checked_moves(text, "apt"), "10001");
  EXPECT_EQ(checked_moves(text, "apt-solidworks-cam"), "11111") << "there it means +Z";
}

TEST(ReadApt, AStepFromAPlaceThatIsNotKnownIsNotChecked) {
  EXPECT_EQ(checked_moves("TRANS/0,0,-20\nGOTO/0,0,10\nTRANS/0,0,0\nGODLTA/10,0,0\nGODLTA/10,0,0\nGOTO/1,1,1\n"
                          "GOTO/1,1,2\n",
                          "apt"),
            "00001");
  const Toolpath path = path_of("GOTO/0,0,7\nGOTO/0,0,3\nTLAXIS/1,0,0\nGODLTA/5,0,0\nGODLTA/2\n");
  expect_vector(path.moves[2].end.axis, 1, 0, 0);
  expect_vector(path.moves[3].end.tip, 7, 0, 3);
}

TEST(ReadApt, OnlyItsOwnOffEndsCompensation) {
  const std::string after = "GOTO/1,0,9\nGOTO/2,0,9\nGOTO/3,0,9\n";
  for (const char* off : {"CUTCOM/OFF,LENGTH", "CUTCOM/ON,LENGTH"})
    EXPECT_EQ(checked_moves("GOTO/0,0,9\nCUTCOM/LEFT\n" + after + off + "\n" + after, "apt"), "1000000") << off;
  EXPECT_EQ(checked_moves("GOTO/0,0,9\nCUTCOM/LEFT\n" + after + "CUTCOM/ADJUST,OFF\n" + after, "apt"), "1000000");
  EXPECT_EQ(checked_moves("GOTO/0,0,9\nCUTCOM/LEFT,LENGTH,3\n" + after, "apt"), "1000");
  EXPECT_EQ(checked_moves("GOTO/0,0,9\nCUTCOM/ON,LENGTH\n" + after, "apt"), "1111");
  EXPECT_EQ(checked_moves("GOTO/0,0,9\nCUTCOM/ADJUST,ON,3\n" + after + "CUTCOM/ADJUST,OFF\n" + after, "apt"),
            "1000011");
}

TEST(ReadApt, NothingUndoesATurnOfATableButInClt) {
  const std::string after = "GOTO/1,0,9\nGOTO/2,0,9\n";
  for (const char* words : {"ROTABL/-90,AAXIS", "ROTABL/ATANGL,-90,AAXIS", "ROTHED/-90,AAXIS"})
    EXPECT_EQ(checked_moves("GOTO/0,0,9\nROTABL/90,AAXIS\n" + after + words + "\n" + after, "apt"), "10000") << words;
  EXPECT_EQ(checked_moves("GOTO/0,0,9\nROTABL/AAXIS,0,BAXIS,90\n" + after, "apt"), "100");
  EXPECT_EQ(checked_moves("GOTO/0,0,9\nROTABL/AAXIS,0,BAXIS,0\n" + after, "apt"), "111");
}

TEST(ReadApt, SubroutinesMirrorsAndScalesAreNotTakenToMoveNothing) {
  for (const char* word : {"CALSUB/1", "DEFSUB/1", "ENDSUB", "MIRROR/XYPLAN", "SCALE/2", "WORKPL/ON", "HOME/5"})
    EXPECT_NE(checked_moves(std::string("GOTO/0,0,9\n") + word + "\nGOTO/1,0,9\n", "apt-creo"), "11") << word;
}

TEST(ReadApt, WhatOneCreoSequenceSaysOfItsPositionsTheNextDoesNot) {
  const std::string text =
      "$$-> FEATNO / 32\n$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nCUTCOM / LEFT\nGOTO / 0,0,9\nCUTCOM / OFF\n"
      "$$-> FEATNO / 33\nCUTCOM / LEFT\nGOTO / 0,0,9\n";
  EXPECT_EQ(checked_moves(text, "apt-creo"), "10");
}

TEST(ReadApt, ACutterDoesNotMakeATurningToolSpin) {
  EXPECT_EQ(checked_moves("TOOLNO/1,TURN\nCUTTER/0.8\nGOTO/0,0,9\nTOOLNO/2,MILL\nCUTTER/8\nGOTO/0,0,9\nGOTO/1,0,9\n",
                          "apt-catia")
                .front(),
            '0');
  EXPECT_EQ(checked_moves("TOOLNO/1,TURN\nCUTTER/0.8\nGOTO/0,0,9\nTOOLNO/2,MILL\nCUTTER/8\nGOTO/0,0,9\nGOTO/1,0,9\n",
                          "apt-catia")
                .back(),
            '1');
}

TEST(ReadApt, PositionsThatMayGoOnAlongACircleOfNclAreNotChecked) {
  const std::string circle = "MULTAX/ON\nGOTO/10,0,0,0,0,1\nCIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0,0,0,1\n";
  EXPECT_EQ(checked_moves(circle + "GOTO/-10,0,0,0,0,1\nGOTO/0,-10,0,0,0,1\nGOTO/9,9,0,0,0,1\nGOTO/0,10,0,0,0,1\n",
                          "apt-nccs"),
            "110011");
}

TEST(ReadApt, ASenseThatFewerThanThreePlacesShowIsNotTaken) {
  const std::string in = "GOTO/10,-5,0\nGOTO/10,0,0\n", arc = "CIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\n";
  const std::string out = "GOTO/-5,10,0\n", lift = "GOTO/-5,10,9\n";
  EXPECT_EQ(checked_moves("UNITS/MM\n" + in + arc + out + lift, "apt"),
            "110"
            "11")
      << "two lines touch the arc";
  EXPECT_EQ(checked_moves("UNITS/MM\n" + in + arc + out + lift + in + arc + out, "apt"),
            "11111"
            "1111");
}

TEST(ReadApt, TransWithoutNumbersUndoesNothing) {
  EXPECT_EQ(checked_moves("TRANS/0,0,-20\nTRANS/\nGOTO/0,0,9\n", "apt"), "0");
}

TEST(ReadApt, CatiaArcsEndWhereTheirLineEnds) {
  const Toolpath path = path_of(
      "$$ CATIA APT VERSION 1.0\nMULTAX\nGOTO/1,0,0,0,1,0\nINDIRV/0,1,0\nTLON,GOFWD/ (CIRCLE/ 0,0,0,$\n "
      "1),ON,(LINE/0,0,0,$\n"
      " 0,1,0)\nGOTO/0,2,0,0,1,0\nFINI\n");
  ASSERT_EQ(path.moves.size(), 3u);
  EXPECT_EQ(path.moves[1].kind, MoveKind::arc);
  EXPECT_EQ(path.moves[1].line, 5u);
  expect_vector(path.moves[1].end.tip, 0, 1, 0);
  expect_vector(path.moves[1].end.axis, 0, 1, 0);
}

TEST(ReadApt, AfterACycleThatIsNotUnderstoodTheStartIsNotKnown) {
  const Toolpath path = path_of(
      "GOTO/0,0,9\nCYCLE/INIT\nGOTO/0,0,8\nCYCLE/DRILL,5\nGOTO/0,0,1\nGOTO/5,0,1\nCYCLE/OFF\nGOTO/9,0,9\nGOTO/9,9,9\n");
  EXPECT_EQ(kinds(path),
            (Kinds{MoveKind::feed, MoveKind::feed, MoveKind::cycle, MoveKind::cycle, MoveKind::feed, MoveKind::feed}));
  EXPECT_EQ(path.moves[2].not_checked_reason, "a cycle whose words are not understood: CYCLE in line 4");
  EXPECT_FALSE(path.moves[4].has_start);
  EXPECT_EQ(path.moves[4].not_checked_reason, "starts at an unknown retract height after a drilling cycle");
  EXPECT_TRUE(path.moves[5].has_start);
  EXPECT_TRUE(path.moves[5].not_checked_reason.empty());
}

TEST(ReadApt, SolidWorksCsysIsNotAppliedAndNoReasonToStop) {
  const Toolpath path = path_of("UNIT/MM\nTRNTYP/WORLD,0,0,0\nCSYS/0,-1.,0,0,1.,0,0,0,0,0,1.,0\nGOTO/1,2,3\nFINI\n");
  EXPECT_EQ(path.dialect, "apt-solidworks-cam");
  EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
}

TEST(ReadApt, CompensationIsReportedOnlyWhereItIsSwitchedOn) {
  EXPECT_EQ(path_of("CUTCOM/OFF\nFEDRAT/1,MMPM\nGOTO/1,2,3\n").notes.size(), 0u);
  const Toolpath path = path_of("UNITS/MM\nGOTO/1,2,3\nCUTCOM/LEFT\nGOTO/1,2,4\nCUTCOM/OFF\n");
  ASSERT_EQ(path.notes.size(), 1u);
  EXPECT_EQ(to_text(path.notes[0]),
            "test.apt:3: warning: 1 CUTCOM statement on: the file does not say whether its positions are the cutter "
            "centre or the contour, so moves that could touch anything within a diameter beside them are not checked; "
            "--cutcom centre says they are [path-cutcom]");
  EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
  EXPECT_EQ(path.moves[1].not_checked_reason, "compensated by CUTCOM: the positions need not be the cutter centre");
}

TEST(ReadApt, UnknownWordsAreCounted) {
  const Toolpath path = path_of("FOO/1\nfoo/2\nBAR\nSPINDL/500,RPM\nGOTO/1,2,3\n");
  EXPECT_EQ(path.words_not_understood, (std::map<std::string, std::size_t>{{"BAR", 1}, {"FOO", 2}}));
}

TEST(ReadApt, AnAxisSlightlyOffIsMadeUnitAndReported) {
  const Toolpath path = path_of("GOTO/1,2,3,0,0,1.0005\nGOTO/1,2,4,0,0,1\n");
  EXPECT_DOUBLE_EQ(path.moves[0].end.axis.norm(), 1);
  EXPECT_EQ(path.notes.front().message, "1 tool axis vector not of length 1 (worst 1.0005) made so");
}

TEST(ReadApt, NamesInLatin1BecomeUtf8) {
  const Toolpath path = path_of(
      "$$ CATIA APT VERSION 1.0\n$$ OPERATION NAME : Per\xe7"
      "age\nGOTO/1,2,3\nEND\n");
  EXPECT_EQ(path.operations.at(0).name,
            "Per\xc3\xa7"
            "age");
}

TEST(ReadApt, PprintNamesAnOperationWhereNothingElseDoes) {
  const Toolpath path = path_of("PPRINT/'1001'\nPPRINT/'ROUGH, 1'\nGOTO/1,2,3\nPPRINT/'FINISH'\nGOTO/1,2,4\n");
  ASSERT_EQ(path.operations.size(), 2u);
  EXPECT_EQ(path.operations[0].name, "ROUGH, 1");
  EXPECT_EQ(path.moves[1].operation, 1u);
}

constexpr const char* kBlock =
    "TOOL PATH/ROUGH,TOOL,BALL\nTLDATA/MILL,10.0,5.0,75.0,0.0,0.0\n"
    "MSYS/100.0,0.0,0.0,0.0,1.0,0.0,1.0,0.0,0.0\nGOTO/1.0,2.0,3.0,0.0,0.0,-1.0\nGOTO/1.0,2.0,4.0\nEND-OF-PATH\n";

TEST(ReadClsf, TheAxisIsModalAndTheFrameIsApplied) {
  const Toolpath path = path_of(kBlock);
  EXPECT_EQ(path.dialect, "nx-clsf");
  ASSERT_EQ(path.moves.size(), 2u);
  expect_vector(path.moves[0].end.tip, 102, 1, -3);
  expect_vector(path.moves[1].end.tip, 102, 1, -4);
  expect_vector(path.moves[1].end.axis, 0, 0, 1);
  EXPECT_TRUE(path.moves[1].has_start);
  EXPECT_EQ(path.operations.at(0).name, "ROUGH");
  EXPECT_EQ(path.tools.at(0).name, "BALL");
  EXPECT_DOUBLE_EQ(path.tools.at(0).cutter->r_mm, 5);
}

TEST(ReadClsf, NothingPassesFromOneBlockToTheNext) {
  const Toolpath path = path_of(std::string(kBlock) +
                                "TOOL PATH/FINISH,TOOL,FLAT\nTLDATA/MILL,6.0,0.0,75.0,0.0,0.0\n"
                                "GOTO/1.0,2.0,3.0\nEND-OF-PATH\n");
  ASSERT_EQ(path.moves.size(), 3u);
  EXPECT_FALSE(path.moves[2].has_start);
  expect_vector(path.moves[2].end.tip, 1, 2, 3);
  expect_vector(path.moves[2].end.axis, 0, 0, 1);
  EXPECT_EQ(path.moves[2].tool, 1u);
}

TEST(ReadClsf, ACurveIsOneMoveToItsLastControlPoint) {
  const Toolpath path = path_of(
      "TOOL "
      "PATH/A,TOOL,B\nGOTO/0.0,0.0,0.0\nNURBS/\nKNOT/0.5,1.0\nCNTRL/1.0,0.0,0.0\nCNTRL/2.0,0.0,0.0\nGOTO/3.0,0.0,0.0\n"
      "NURBS/\nKNOT/1.0\nCNTRL/4.0,0.0,0.0\nEND-OF-PATH\n");
  ASSERT_EQ(path.moves.size(), 4u);
  EXPECT_EQ(path.moves[1].kind, MoveKind::arc);
  EXPECT_EQ(path.moves[1].line, 3u);
  EXPECT_EQ(path.moves[1].not_checked_reason, "a NURBS whose knots, points or axis are not those of a cubic curve");
  expect_vector(path.moves[1].end.tip, 2, 0, 0);
  expect_vector(path.start_of(2).tip, 2, 0, 0);
  expect_vector(path.moves[3].end.tip, 4, 0, 0);
}

TEST(ReadClsf, TheToolNumberOfABlockDoesNotStickToTheNextTool) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nTLDATA/MILL,6.0,0.0,75.0,0.0,0.0\nLOAD/TOOL,2,ADJUST,2 \nGOTO/0.0,0.0,0.0\nEND-OF-PATH\n"
      "TOOL PATH/C,TOOL,D\nTLDATA/MILL,8.0,0.0,75.0,0.0,0.0\nGOTO/0.0,0.0,0.0\nEND-OF-PATH\n");
  EXPECT_EQ(path.tools.at(0).number, 2);
  EXPECT_FALSE(path.tools.at(1).number);
}

TEST(ReadApt, KeepsTheSmallerOfTwoLengthsOfATool) {
  const auto tool = [](const std::string& first, const std::string& second) {
    return path_of("UNITS/MM\nCUTTER/10\n" + first + "\nGOTO/0,0,0\nGOHOME\n" + second + "\nGOTO/1,0,0\nFINI\n")
        .tools.at(0);
  };
  EXPECT_EQ(tool("LOADTL/1,LENGTH,45", "LOADTL/1,LENGTH,40").loaded_length_mm, 40);
  EXPECT_TRUE(tool("LOADTL/1,LENGTH,45", "LOADTL/1,LENGTH,40").has_other_length);
  EXPECT_FALSE(tool("LOADTL/1,LENGTH,45", "LOADTL/1,LENGTH,45").has_other_length);
  EXPECT_FALSE(tool("LOADTL/1,LENGTH,45", "LOADTL/1").has_other_length);
}

}  // namespace
}  // namespace gouge::read_toolpath_test
