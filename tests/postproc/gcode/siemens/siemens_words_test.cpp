#include <algorithm>
#include <numbers>

#include "tests/postproc/gcode/siemens/siemens_program.h"

// Each class of words by a small program.

namespace gouge::siemens_words_test {
namespace {

using test::expect_at;
using test::full_setup;
using test::kHead;
using test::path_of_siemens;
using test::tip_after;

constexpr double kPi = std::numbers::pi;

TEST(SiemensWords, CoordinatesAreAbsoluteOrSteps) {
  expect_at(tip_after("G1 X1 Y2 Z3 F100\nG91 X1 Z-1\nG90 Y5\n"), 2, 5, 2);
  expect_at(tip_after("G1 X1 Y2 Z3 F100\nX=IC(2) Y=AC(7) Z=1+2*3\n"), 3, 7, 7);
  expect_at(tip_after("G1X1Y2Z3F100\n"), 1, 2, 3);
  expect_at(tip_after("N10 G1 X-1.5 Y+2 Z.5 F100 ; a comment\n"), -1.5, 2, 0.5);
  expect_at(tip_after("g1 x1 y2 z=10EX-1 f100\n"), 1, 2, 1);
}

TEST(SiemensWords, ProgramsAreRecognised) {
  const std::string blocks = "N10 DEF REAL _A\nN20 G710 G17\nN30 TRAFOOF\nN40 _A=5\nN50 G0 X=_A\n";
  EXPECT_TRUE(is_gcode(blocks));
  EXPECT_FALSE(is_gcode("PARTNO/A\nINSERT/TRAORI\nGOTO/1,2,3\nGOTO/1,2,4\nGOTO/1,2,5\nGOTO/1,2,6\nFINI\n"));
}

TEST(SiemensWords, InchesAreConverted) {
  expect_at(tip_after("G70\nG1 X1 Y2 Z0.5 F100\n"), 25.4, 50.8, 12.7);
  expect_at(tip_after("G700\nTRANS X1\nG1 X1 Y2 Z0.5 F100\nG710\nZ3\n"), 50.8, 50.8, 3);
}

TEST(SiemensWords, TheSpeedOfTheSpindleHoldsUntilTheNext) {
  const Toolpath path = path_of_siemens(kHead + "G1 Z5 F250 S3000 M3\nZ4\nG4 S5\nS1=4500\nZ3\nM30\n");
  ASSERT_EQ(path.moves.size(), 4U);
  EXPECT_EQ(path.moves[1].spindle_rpm, 3000);
  EXPECT_EQ(path.moves[2].spindle_rpm, 3000);
  EXPECT_EQ(path.moves[3].spindle_rpm, 4500);
}

TEST(SiemensWords, MotionCodesMakeTheirKinds) {
  const Toolpath path = path_of_siemens(kHead + "G1 Z5 F250\nG0 X5\nG2 X10 Y5 I5 J0\nM30\n");
  ASSERT_EQ(path.moves.size(), 4U);
  EXPECT_EQ(path.moves[1].kind, MoveKind::feed);
  EXPECT_DOUBLE_EQ(path.moves[1].feed_mm, 250);
  EXPECT_EQ(path.moves[2].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[3].kind, MoveKind::arc);
  EXPECT_EQ(path.moves[1].line, 5U);
}

TEST(SiemensWords, ArcsByCentreRadiusAngleAndPoint) {
  const auto arc_of = [](const std::string& block) {
    const Toolpath path = path_of_siemens(kHead + "G1 X10 Y0 Z0 F100\n" + block + "\nM30\n");
    EXPECT_EQ(path.arcs.size(), 1U) << block;
    if (path.arcs.empty()) return std::pair{PathArc{}, Vec3(Vec3::Zero())};
    return std::pair{path.arcs[0], path.moves.back().end.tip};
  };
  for (const std::string block : {"G3 X0 Y10 I-10 J0", "G3 X0 Y10 I=AC(0) J=AC(0)", "G3 X0 Y10 CR=10", "G3 I-10 AR=90",
                                  "G3 X0 Y10 AR=90", "CIP X0 Y10 I1=7.0710678118654755 J1=7.0710678118654755"}) {
    const auto [arc, end] = arc_of(block);
    expect_at(arc.center, 0, 0, 0, 1e-7);
    expect_at(arc.axis, 0, 0, 1, 1e-7);
    EXPECT_NEAR(arc.sweep_rad, kPi / 2, 1e-7) << block;
    expect_at(end, 0, 10, 0);
  }
  EXPECT_NEAR(arc_of("G2 X0 Y10 CR=-10").first.sweep_rad, kPi * 1.5, 1e-7);
  EXPECT_NEAR(arc_of("G3 I-10 J0 Z-6 TURN=2").first.sweep_rad, 6 * kPi, 1e-7);
  EXPECT_NEAR(arc_of("G3 X0 Y10 I-10 J0 Z-6 TURN=2").first.sweep_rad, 4.5 * kPi, 1e-7);
}

TEST(SiemensWords, ArcsInOtherPlanesWithoutALength) {
  ProgramSetup setup;
  setup.tool_length_mm = 80;
  const Toolpath path = path_of_siemens(kHead + "G18 G1 X10 Y0 Z0 D0 F100\nG2 X0 Z10 I-10 K0\nM30\n", setup);
  ASSERT_EQ(path.arcs.size(), 1U);
  // From the second axis of the plane to the first is counterclockwise about Y.
  expect_at(path.arcs[0].axis, 0, -1, 0);
}

TEST(SiemensWords, CipInSpace) {
  const Toolpath path = path_of_siemens(kHead + "G1 X10 Y0 Z0 F100\nCIP X-10 Y0 Z0 I1=0 J1=0 K1=10\nM30\n");
  ASSERT_EQ(path.arcs.size(), 1U);
  expect_at(path.arcs[0].center, 0, 0, 0);
  expect_at(path.arcs[0].axis, 0, -1, 0);
  EXPECT_NEAR(path.arcs[0].sweep_rad, kPi, 1e-9);
}

TEST(SiemensWords, DrillingCyclesExpandToTheirMotions) {
  const Toolpath path = path_of_siemens(kHead + "G1 Z20 F100\nMCALL CYCLE81(10,0,3,-6)\nX5 Y6\nX7\nMCALL\nX9\nM30\n");
  ASSERT_EQ(path.moves.size(), 11U);
  const Vec3 expected[] = {{5, 6, 20}, {5, 6, 3},  {5, 6, -6}, {5, 6, 10}, {7, 6, 10},
                           {7, 6, 3},  {7, 6, -6}, {7, 6, 10}, {9, 6, 10}};
  for (std::size_t i = 0; i < 9; ++i)
    expect_at(path.moves[i + 2].end.tip, expected[i].x(), expected[i].y(), expected[i].z());
  EXPECT_EQ(path.moves[3].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[4].kind, MoveKind::feed);
}

TEST(SiemensWords, CyclesOfOtherForms) {
  const auto moves_of = [](const std::string& cycle) {
    return path_of_siemens(kHead + "G1 Z20 F100\n" + cycle + "\nM30\n").moves.size() - 2;
  };
  EXPECT_EQ(moves_of("CYCLE82(10,0,3,-6,,1)"), 3U);
  EXPECT_EQ(moves_of("CYCLE83(10,0,3,,6,-2,,1,0,0,1,0)"), 3U);
  EXPECT_EQ(moves_of("CYCLE84(10,0,3,-6,,0,5,,1,0,200,200)"), 4U);
  EXPECT_EQ(moves_of("CYCLE840(10,0,3,-6,,0,4,3,1,,1)"), 4U);
  EXPECT_EQ(moves_of("CYCLE85(10,0,3,-6,,0,200,300)"), 4U);
  EXPECT_EQ(moves_of("CYCLE87(10,0,3,-6,,3)"), 3U);
  EXPECT_EQ(moves_of("CYCLE88(10,0,3,-6,,0,3)"), 3U);
  EXPECT_EQ(moves_of("CYCLE89(10,0,3,-6,,0)"), 4U);
}

TEST(SiemensWords, TraoriStatesTheTipAndKeepsTheWinding) {
  const Toolpath path =
      path_of_siemens(kHead + "G0 B0 C0\nTRAORI\nG0 X1 Y2 Z50\nG1 X3 Y4 Z5 B90 C0 F100\nC370\nTRAFOOF\nM30\n", [] {
        ProgramSetup setup = full_setup();
        setup.winds_as_programmed = true;
        setup.start = "G0";
        return setup;
      }());
  ASSERT_NE(path.joints, nullptr);
  const Move& last = path.moves.back();
  EXPECT_TRUE(last.not_checked_reason.empty());
  expect_at(last.end.tip, 3, 4, 5);
  EXPECT_FALSE(last.runs_joints);
  EXPECT_NEAR((*path.joints->end.back())[0], 370 * kPi / 180, 1e-12);
}

TEST(SiemensWords, VectorsStateTheToolAxis) {
  const Toolpath path =
      path_of_siemens(kHead + "TRAORI\nROT Z90\nG1 X1 Y0 Z0 A3=0 B3=0 C3=1 F100\nX2 A3=1 C3=1\nX3\nM30\n");
  const std::size_t last = path.moves.size() - 1;
  expect_at(path.moves[last].end.axis, 0, std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2);
  expect_at(path.moves[last].end.tip, 0, 3, 0);
  EXPECT_TRUE(path.moves[last].not_checked_reason.empty());
}

TEST(SiemensWords, RotaryMeasuresStateTheWay) {
  const auto angle_after = [](const std::string& blocks) {
    const Toolpath path =
        path_of_siemens(kHead + "G0 B0 C0\nTRAORI\nG0 X1 Y2 Z50\nG1 X3 F100\n" + blocks + "\nM30\n", full_setup());
    return (*path.joints->end.back())[0] * 180 / kPi;
  };
  EXPECT_NEAR(angle_after("C=DC(350)"), -10, 1e-9);
  EXPECT_NEAR(angle_after("C=ACP(350)"), 350, 1e-9);
  EXPECT_NEAR(angle_after("C90\nC=ACN(100)"), -260, 1e-9);
  EXPECT_NEAR(angle_after("C=IC(400)"), 400, 1e-9);
  EXPECT_NEAR(angle_after("C170"), 170, 1e-9);
}

TEST(SiemensWords, ToolsByNameAreTools) {
  const Toolpath path = path_of_siemens(kHead + "G1 Z5 F100\nT=\"DRILL 3\" M6\nG0 X0 Y0 Z9 D1\nM30\n");
  ASSERT_EQ(path.tools.size(), 2U);
  EXPECT_EQ(path.tools[0].name, "MILL 8");
  EXPECT_EQ(path.tools[1].name, "DRILL 3");
  EXPECT_EQ(path.moves.back().tool, 1U);
}

TEST(SiemensWords, WithoutM6TChangesTheTool) {
  const Toolpath path = path_of_siemens("G17 G71 G90 G94 G60 G54\nT1 D1\nG0 X0 Y0 Z9\nT2 D1\nG0 X1 Y0 Z9\nM30\n");
  ASSERT_EQ(path.tools.size(), 2U);
  EXPECT_EQ(path.tools[1].number, 2);
}

// MD22550 states whether T loads the tool, or prepares it.
TEST(SiemensWords, WithoutM6TheMeaningOfTIsADefault) {
  const auto fact_of = [](const std::string& change) {
    const Toolpath path = path_of_siemens("G17 G71 G90 G94 G60 G54\n" + change + " D1\nG0 X0 Y0 Z9\nG1 Z1 F9\nM30\n");
    return *std::ranges::find(path.assumptions, Subject::statements, &Assumption::subject);
  };
  const Assumption fact = fact_of("T1");
  EXPECT_EQ(fact.basis, Basis::by_default);
  EXPECT_EQ(fact.line, 2U);
  EXPECT_NE(fact.evidence.find("MD22550"), std::string::npos) << fact.evidence;
  EXPECT_NE(fact.remedy.find("M6"), std::string::npos) << fact.remedy;
  EXPECT_EQ(fact_of("T1 M6").basis, Basis::derived);
}

TEST(SiemensWords, MessagesNameOperations) {
  const Toolpath path = path_of_siemens(kHead + "MSG(\"FINISH; WALL\")\nG1 Z5 F100\nM30\n");
  ASSERT_EQ(path.operations.size(), 1U);
  EXPECT_EQ(path.operations[0].name, "FINISH; WALL");
}

TEST(SiemensWords, SmoothingWithinTheToleranceIsChecked) {
  ProgramSetup setup;
  setup.tip_tolerance_mm = 0.05;
  for (const char* block : {"CYCLE832(0.014,1,1)", "G64", "G641 ADIS=0.02 ADISPOS=0.05", "CTOL=0.028\nG642",
                            "COMPCAD CTOL=0.028", "CTOL=0.014\nG643 COMPON"})
    expect_at(tip_after(std::string(block) + "\nG1 Z5 F100\n", setup), 0, 0, 5);
}

}  // namespace
}  // namespace gouge::siemens_words_test
