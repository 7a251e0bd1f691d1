// Arcs, splines, cycles and compensation, with the numbers of real files typed in.
#include <cmath>
#include <numbers>

#include "postproc/cldata/parsing/arc_statement.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/support/real_arcs.h"

namespace gouge::read_motion_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

using real_arcs::ArcCase;
using real_arcs::kArcs;

class ArcSenses : public ::testing::TestWithParam<ArcCase> {};

INSTANTIATE_TEST_SUITE_P(All, ArcSenses, ::testing::ValuesIn(kArcs),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ArcSenses, AreThoseOfTheDialect) {
  const Toolpath path = path_of(GetParam().text);
  ASSERT_EQ(path.moves.size(), 3U);
  EXPECT_EQ(path.moves[2].not_checked_reason, "");
  ASSERT_EQ(path.moves[2].curve_kind, CurveKind::arc);
  const PathArc& arc = path.arcs[path.moves[2].curve];
  EXPECT_NEAR(arc.sweep_rad / kDegree, GetParam().sweep_deg, 0.02);
  EXPECT_NEAR(arc.axis.z(), GetParam().axis_z, 1e-3);
}

TEST(ReadArcs, TheSameStatementRunsTheOtherWayRoundInAnotherDialect) {
  const std::string middle = "GOTO/0.,-5.,0.\nGOTO/5.,0.,0.\nCIRCLE/0.,0.,0.,0,0,1.,5.\nGOTO/0.,5.,0.\n";
  const Toolpath nx = path_of("TOOL PATH/A,TOOL,B\n" + middle + "END-OF-PATH\n");
  const Toolpath swcam = path_of("TRNTYP/WORLD,0,0,0\n" + middle + "FINI\n");
  EXPECT_NEAR(nx.arcs.at(0).sweep_rad / kDegree, -270, 1e-9);
  EXPECT_NEAR(swcam.arcs.at(0).sweep_rad / kDegree, 90, 1e-9);
}

TEST(ReadArcs, AFrameTurnsCentreAndAxisWithThePositions) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nMSYS/100.0,0.0,0.0,0.0,1.0,0.0,1.0,0.0,0.0\nGOTO/5.0,0.0,0.0\n"
      "CIRCLE/0.0,0.0,0.0,0.0,0.0,1.0,5.0\nGOTO/0.0,5.0,0.0\nEND-OF-PATH\n");
  expect_vector(path.arcs.at(0).center, 100, 0, 0);
  expect_vector(path.arcs.at(0).axis, 0, 0, -1);
  EXPECT_NEAR(path.arcs.at(0).sweep_rad / kDegree, -270, 1e-9);
}

TEST(ReadArcs, StartAndEndAtOnePositionAreAFullCircle) {
  const Toolpath path = path_of(
      "UNITS/ MM \nOPFEATSTART/A\nGOTO/ 37.0,67.5,-19.5 \n"
      "CIRCLE/ 67.5,67.5,-19.5,0,0,1,30.5,COUNTERCLOCKWISE \nGOTO/ 37.0,67.5,-19.5 \nFINI\n");
  EXPECT_NEAR(path.arcs.at(0).sweep_rad, 2 * std::numbers::pi, 1e-12);
}

TEST(ReadArcs, TimesAreTurnsOfAHelix) {
  const std::string text =
      "TOOL PATH/A,TOOL,B\nGOTO/5.0,0.0,10.0\nCIRCLE/0.0,0.0,10.0,0.0,0.0,-1.0,5.0,.06,.5,10.,0.,TIMES,2\n";
  const Toolpath path = path_of(text + "GOTO/5.0,0.0,4.0\nEND-OF-PATH\n");
  EXPECT_NEAR(path.arcs.at(0).sweep_rad, -4 * std::numbers::pi, 1e-12);
  const Toolpath elsewhere = path_of(text + "GOTO/0.0,5.0,4.0\nEND-OF-PATH\n");
  EXPECT_EQ(elsewhere.moves.at(1).not_checked_reason, ArcProblems::kTimes);
}

TEST(ReadArcs, WhatDoesNotFitOnOneCircleIsReportedAndNotChecked) {
  const Toolpath path =
      path_of("TRNTYP/WORLD,0,0,0\nGOTO/5.,0,0\nCIRCLE/0,0,0,0,0,1.\nGOTO/0,5.1,0\nGOTO/9.,9.,9.\nFINI\n");
  EXPECT_EQ(path.moves.at(1).not_checked_reason, "the arc's start, end and radius do not lie on one circle");
  EXPECT_EQ(path.moves.at(1).curve_kind, CurveKind::none);
  EXPECT_TRUE(path.moves.at(2).not_checked_reason.empty());
  bool is_reported = false;
  for (const Diagnostic& note : path.notes)
    is_reported = is_reported || (note.code == "path-arc-radius" && note.line == 4);
  EXPECT_TRUE(is_reported);
}

TEST(ReadArcs, TheAngleAnArcStatesMustLeadToItsEnd) {
  const std::string before = "UNITS/MM\nGOTO/5,0,0\nMOVARC/0,0,0,0,0,1,5,ANGLE, ";
  EXPECT_NEAR(path_of(before + "450\nGOTO/0,5,0\nFINI\n").arcs.at(0).sweep_rad / kDegree, 450, 1e-9);
  EXPECT_EQ(path_of(before + "270\nGOTO/0,5,0\nFINI\n").moves.at(1).not_checked_reason,
            "the angle the arc states does not lead to its end");
}

// Its older posts write a clockwise arc with the vector of a counter-clockwise one.
TEST(ReadArcs, AHalfTurnOfAutodeskIsCheckedWhereTheFileShowsWhichPostWroteIt) {
  const std::string head = "MODE/MILL\nUNITS/MM\nMULTAX/OFF\nGOTO/61,0,-5\n";
  const std::string half = "MOVARC/61,10,-5,0,0,1,10,ANGLE,180\nGOTO/61,20,-5\n";
  const std::string turned = "MOVARC/61,10,-5,0,0,-1,10,ANGLE,90\nGOTO/51,10,-5\n";
  const std::string not_turned = "MOVARC/61,10,-5,0,0,1,10,ANGLE,90\nGOTO/71,10,-5\n";
  const std::string open = "nothing in the file states which way round its arcs run";
  const auto reason = [&](const std::string& after) {
    return std::string(path_of(head + half + after + "END\nFINI\n").moves.at(1).not_checked_reason);
  };
  const std::string back = "GOTO/61,0,-5\n";
  EXPECT_EQ(reason(""), open);
  EXPECT_EQ(reason(back + not_turned), open) << "counter-clockwise in both posts";
  EXPECT_EQ(reason("GOTO/61,20,-5\nMOVARC/61,10,-5,0,0,-1,10,ANGLE,90\nGOTO/71,10,-5\n"), "");
  EXPECT_EQ(reason(back + turned), "");
  EXPECT_EQ(reason(back + turned + back + "MOVARC/61,10,-5,0,0,1,10,ANGLE,90\nGOTO/51,10,-5\n"), open)
      << "one that runs left-handed";
}

TEST(ReadArcs, AWholeTurnOfAutodeskIsOpenOnlyWhereItRises) {
  const std::string head = "MODE/MILL\nUNITS/MM\nMULTAX/OFF\nGOTO/61,0,-5\nMOVARC/61,10,-5,0,0,1,10,ANGLE,";
  EXPECT_EQ(path_of(head + "360\nGOTO/61,0,-5\nEND\nFINI\n").moves.at(1).not_checked_reason, "");
  EXPECT_NE(path_of(head + "360\nGOTO/61,0,-4\nEND\nFINI\n").moves.at(1).not_checked_reason, "");
  EXPECT_EQ(path_of(head + "-180\nGOTO/61,20,-5\nEND\nFINI\n").moves.at(1).not_checked_reason,
            "an arc statement that is not understood");
}

TEST(ReadArcs, AFileOfNoKnownDialectIsReadInTheSenseThatGoesOnSmoothly) {
  const Toolpath path = path_of(
      "UNITS/MM\nGOTO/5,-9,0\nGOTO/5,0,0\nCIRCLE/0,0,0,0,0,1,5\nGOTO/0,5,0\nGOTO/-9,5,0\n"
      "CIRCLE/-9,2,0,0,0,1,3\nGOTO/-9,-1,0\n");
  EXPECT_NEAR(path.arcs.at(0).sweep_rad / kDegree, 90, 1e-9);
  EXPECT_NEAR(path.arcs.at(1).sweep_rad / kDegree, 180, 1e-9);
  EXPECT_EQ(path.moves.at(4).not_checked_reason, "");
}

TEST(ReadArcs, APlaceThatCannotBeDistinguishedFromAFullCircleIsNotChecked) {
  const Toolpath path = path_of("TRNTYP/WORLD,0,0,0\nGOTO/5.,0,0\nCIRCLE/0,0,0,0,0,1.\nGOTO/5.,.0001,0\nFINI\n");
  EXPECT_FALSE(path.moves.at(1).not_checked_reason.empty());
}

TEST(ReadSplines, AnNxNurbsIsACubicFromThePositionBeforeItToItsLastPoint) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nGOTO/-254.9774,466.5681,206.8891\nNURBS/\n"
      "KNOT/0.0416667,0.3750000,0.6250000,0.9583333,1.0000000\nCNTRL/-254.9774,466.2698,206.9401\n"
      "CNTRL/-254.9775,463.5692,207.2380\nCNTRL/-254.9776,459.2589,209.0136\nCNTRL/-254.9778,454.6135,213.9021\n"
      "CNTRL/-254.9779,453.0599,218.2973\nCNTRL/-254.9779,452.9000,221.0096\nCNTRL/-254.9779,452.8642,221.3100\n"
      "GOTO/-254.9779,452.7668,223.7424\nEND-OF-PATH\n");
  ASSERT_EQ(path.moves.at(1).curve_kind, CurveKind::spline);
  const PathSpline& spline = path.splines.at(0);
  EXPECT_EQ(spline.pieces.size(), 5U);
  EXPECT_EQ(spline.pieces.front().control.front(), path.moves[0].end.tip);
  EXPECT_EQ(spline.pieces.back().control.back(), path.moves[1].end.tip);
}

using Heights = std::vector<double>;

Heights heights(const Toolpath& path) {
  Heights all;
  for (const Move& move : path.moves) {
    if (move.kind == MoveKind::cycle) all.push_back(move.end.tip.z());
  }
  return all;
}

TEST(ReadCycles, EveryDialectGoesDownAndUpByItsOwnWords) {
  EXPECT_EQ(heights(path_of("TOOL PATH/A,TOOL,B\nGOTO/66.0,0.0,300.0\nCYCLE/DRILL,RAPTO,3.0,FEDTO,-4.0,MMPM,250.0\n"
                            "GOTO/66.0,0.0,240.0\nGOTO/-255.0,0.0,240.0\nCYCLE/OFF\nEND-OF-PATH\n")),
            (Heights{243, 236, 243, 243, 236, 243}));
  EXPECT_EQ(heights(path_of("TRNTYP/WORLD,0,0,0\nGOTO/77.5,145.,25.\nCYCLE/INIT\n"
                            "CYCLE/DEEP2,FEDTO,28.5,1STPECK,5.,SUBPECK,2.,MMPM,382.27,RAPTO,3.,RTRCTO,27.5\n"
                            "GOTO/77.5,145.,-2.5\nGOTO/77.5,20.,-2.5\nCYCLE/OFF\nFINI\n")),
            (Heights{0.5, -31, 25, 25, 0.5, -31, 25}));
  EXPECT_EQ(
      heights(path_of(
          "$$* Pro/CLfile\nUNITS / MM\nGOTO / 0, 0, 50\nCYCLE / DEEP, DEPTH, 3.5, STEP, 1.0, MMPM, 50.0, CLEAR,$\n"
          " 1.0\nGOTO / 0, 0, 0\nCYCLE / OFF\nFINI\n")),
      (Heights{1, -3.5, 1}));
  EXPECT_EQ(heights(path_of(
                "$$ CATIA APT VERSION 1.0\nGOTO  /   98.0,  100.0,   25.0\nCYCLE/DRILL,    3.000000,    5.000000\n"
                "GOTO  /   98.0,  100.0,   20.0\nCYCLE/OFF\nEND\n")),
            (Heights{17, 25}));
  EXPECT_EQ(heights(path_of("UNITS/ MM\nOPFEATSTART/A\nGOTO/ 67.5,120.5,25.0 \nCYCLE/ ON \n"
                            "CYCLE/ DRILL,G98,12.5,PECKING,5.0,2.0,MMPM,187.165839,3.0,46.5 46.5 DWELL,0.0 \n"
                            "GOTO/ 67.5,120.5,-21.5 \nCYCLE/ OFF \nFINI\n")),
            (Heights{-18.5, -34, 25}));
  EXPECT_EQ(heights(path_of("OPNAME/ 'A'\nUNITS/ MM\nGOTO/ 4., 2., 50.\n"
                            "CYCLE/ DEEP, DEPTH, 8., STEP, 2., PERMIN, 100., CLEAR, 15., RETURN, 15., RAPTO, 10.\n"
                            "FEDRAT/ 100.\nGOTO/ 4., 2., -1.\nCYCLE/ OFF\nEND/\n")),
            (Heights{14, -9, 14}));
}

TEST(ReadCycles, TheToolGoesAcrossBeforeItGoesDownAndUpBeforeItGoesAcross) {
  const Toolpath path = path_of(
      "TRNTYP/WORLD,0,0,0\nGOTO/0,0,9.\nCYCLE/DRILL,FEDTO,2.,MMPM,1.,RAPTO,1.,RTRCTO,1.\n"
      "GOTO/5.,0,0\nGOTO/7.,0,4.\nCYCLE/OFF\nGOTO/0,0,9.\nFINI\n");
  ASSERT_EQ(path.moves.size(), 15U);
  expect_vector(path.moves[1].end.tip, 5, 0, 9);
  expect_vector(path.moves[2].end.tip, 5, 0, 1);
  expect_vector(path.moves[5].end.tip, 5, 0, 5);
  expect_vector(path.moves[6].end.tip, 7, 0, 5);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(path.moves[i].line, 4U);
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const bool is_on_rising_part = i >= 5 && i < 12;  // first up and across, straight, or first across
    EXPECT_EQ(path.moves[i].is_covered(), is_on_rising_part);
    EXPECT_EQ(path.moves[i].not_checked_reason.empty(), !is_on_rising_part);
  }
  EXPECT_FALSE(path.moves[7].has_start);
  expect_vector(path.moves[8].end.tip, 7, 0, 5);
  EXPECT_FALSE(path.moves[9].has_start);
  expect_vector(path.moves[10].end.tip, 7, 0, 1);
  expect_vector(path.moves[11].end.tip, 7, 0, 5);
}

TEST(ReadCycles, WhatCouldMeanTwoThingsIsNotChecked) {
  for (const char* cycle :
       {"CYCLE/BORE,FEDTO,2.,RAPTO,1.,ORIENT,0", "CYCLE/THREAD,FEDTO,2.,RAPTO,1.", "CYCLE/DRILL,RAPTO,1."}) {
    const Toolpath path = path_of(std::string("TRNTYP/WORLD,0,0,0\nGOTO/0,0,9.\n") + cycle + "\nGOTO/5.,0,0\nFINI\n");
    EXPECT_EQ(path.moves.at(1).not_checked_reason, "a cycle whose words are not understood: CYCLE in line 3") << cycle;
  }
}

TEST(ReadCutcom, LengthOfTheToolIsNoRadius) {
  const Toolpath path = path_of(
      "OPNAME/ 'A'\nCUTCOM/ ON, LENGTH, 3\nGOTO/ 0, 0, 0\nGOTO/ 1, 0, 0\nCUTCOM/ ON\n"
      "CUTCOM/ LEFT, XYPLAN, OSETNO, 3\nGOTO/ 2, 0, 0\nEND/\n");
  EXPECT_TRUE(path.moves.at(1).not_checked_reason.empty());
  EXPECT_FALSE(path.moves.at(2).not_checked_reason.empty());
}

TEST(ReadCutcom, CreoSaysWhereItsPositionsAreTheCutterCentre) {
  const std::string text = "GOTO / 0, 0, 0\nCUTCOM / LEFT, 1\nGOTO / 1, 0, 0\nCUTCOM / OFF\nGOTO / 2, 0, 0\nFINI\n";
  EXPECT_TRUE(path_of("$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\n" + text).moves.at(1).not_checked_reason.empty());
  const Toolpath reported = path_of("$$-> FEATNO / 1\n" + text);
  EXPECT_FALSE(reported.moves.at(1).not_checked_reason.empty());
  EXPECT_FALSE(reported.moves.at(2).not_checked_reason.empty()) << "it starts at a compensated position";
  ReadOptions options;
  options.is_cutcom_centre = true;
  EXPECT_TRUE(read_toolpath("a", "$$-> FEATNO / 1\n" + text, options).toolpath->moves.at(1).not_checked_reason.empty());
}

TEST(ReadMotion, NothingIsSweptAcrossCreoSequencesAndItIsReported) {
  const Toolpath path =
      path_of("$$* Pro/CLfile\n$$-> FEATNO / 1\nGOTO / 0, 0, 0\n$$-> FEATNO / 2\nGOTO / 1, 0, 0\nFINI\n");
  EXPECT_FALSE(path.moves.at(1).has_start);
  bool is_reported = false;
  for (const Diagnostic& note : path.notes) is_reported = is_reported || note.code == "path-not-swept";
  EXPECT_TRUE(is_reported);
}

TEST(ReadCycles, ACountersinkThatItsToolDoesNotReachIsNamed) {
  const auto reason_of = [](const std::string& diameter) {
    const Toolpath path = path_of(
        "TOOL PATH/D1,TOOL,DR8\nTLDATA/DRILL,8.0000,0.0000,118.0000,60.0000,0.0000\n"
        "MSYS/0,0,0,1,0,0,0,1,0\nGOTO/50,50,20,0,0,1\nCYCLE/DRILL,CSINK," +
        diameter + ",RAPTO,3.0000,MMPM,250.0000\nGOTO/50,50,0\nCYCLE/OFF\nEND-OF-PATH\n");
    return std::string(path.moves.back().not_checked_reason);
  };
  EXPECT_EQ(reason_of("6.0000"), "");
  EXPECT_TRUE(reason_of("9.0000").starts_with("a countersink (CSINK) to a diameter that the cone of its tool does not"))
      << reason_of("9.0000");
}

}  // namespace
}  // namespace gouge::read_motion_test
