#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/postproc/gcode/heidenhain/klartext.h"

namespace gouge::klartext::klartext_motion_test {
namespace {

const std::string kStart = "L X+0 Y+0 Z+10 R0 FMAX\n";

PathArc last_arc(const Toolpath& path) {
  if (path.moves.empty() || path.moves.back().curve_kind != CurveKind::arc) {
    ADD_FAILURE() << "the last move is no arc: " << last_reason(path);
    return {};
  }
  return path.arcs[path.moves.back().curve];
}

TEST(KlartextLines, HaveTheSpeedOfTheSpindleOfTheLastToolCall) {
  const Toolpath path = blocks_of("TOOL CALL 1 Z S2500\n" + kStart + "L X+5 F200\nTOOL CALL S3000\nL X+6\n");
  ASSERT_GE(path.moves.size(), 3U);
  EXPECT_EQ(path.moves[1].spindle_rpm, 2500);
  EXPECT_EQ(path.moves.back().spindle_rpm, 3000);
}

TEST(KlartextLines, GoToAbsoluteAndIncrementalPlaces) {
  const Toolpath path = blocks_of(kStart + "L X+5 F200\nL IX+2 IZ-1\nL Y-3 FMAX\nL Z 25.000\n");
  EXPECT_EQ(tips(path), "(0,0,10) (5,0,10) (7,0,9) (7,-3,9) (7,-3,25)");
  EXPECT_EQ(path.moves[0].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[1].kind, MoveKind::feed);
  EXPECT_EQ(path.moves[3].kind, MoveKind::rapid);
  EXPECT_DOUBLE_EQ(path.moves[4].feed_mm, 200);  // FMAX holds in its block alone
  EXPECT_EQ(path.moves[1].line, 4U);
}

TEST(KlartextLines, AreInTheUnitOfTheProgram) {
  const Toolpath path = path_of("0 BEGIN PGM A INCH\nTOOL CALL 1 Z\nL X+1 Y+0 Z+2 FMAX\nEND PGM A INCH\n");
  EXPECT_EQ(tips(path), "(25.4,0,50.8)");
  EXPECT_EQ(path.unit, LengthUnit::inch);
}

TEST(KlartextLines, ArePolarAboutThePole) {
  const Toolpath path = blocks_of(kStart + "CC X+10 Y+0\nLP PR+20 PA+90 F100\nLP IPA+90\nLP PR+5 PA+0\n");
  EXPECT_EQ(tips(path), "(0,0,10) (10,20,10) (-10,0,10) (15,0,10)");
  expect_open(kStart + "LP PR+20 PA+90 F100\n", "the pole");
  expect_open(kStart + "CC X+10 Y+0\nLP PA+90 F100\n", "the radius");
}

TEST(KlartextArcs, RunAboutThePole) {
  const PathArc arc = last_arc(blocks_of(kStart + "CC X+10 Y+0\nC X+10 Y+10 DR- F100\n"));
  EXPECT_NEAR((arc.center - Vec3(10, 0, 10)).norm(), 0, 1e-12);
  EXPECT_NEAR(arc.sweep_rad, std::numbers::pi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(arc.axis.z(), -1);
  const PathArc other = last_arc(blocks_of(kStart + "CC X+10 Y+0\nC X+10 Y+10 DR+ F100\n"));
  EXPECT_NEAR(other.sweep_rad, 3 * std::numbers::pi / 2, 1e-12);
}

TEST(KlartextArcs, AreFullCirclesWhereTheyEndAtTheirStart) {
  for (const std::string block : {"C DR+ F100\n", "C X+0 Y+0 DR+ F100\n", "C IX+0 DR+ F100\n"})
    EXPECT_NEAR(last_arc(blocks_of(kStart + "CC IX+10 IY+0\n" + block)).sweep_rad, 2 * std::numbers::pi, 1e-12);
}

TEST(KlartextArcs, HaveARadiusWhoseSignGivesTheirSize) {
  // The four arcs of the manual, from X40 Y40 to X70 Y40.
  const auto arc = [&](const std::string& words) {
    return last_arc(blocks_of("L X+40 Y+40 Z+0 R0 FMAX\nCR X+70 Y+40 " + words + " F200\n"));
  };
  EXPECT_LT(arc("R+20 DR-").sweep_rad, std::numbers::pi);
  EXPECT_LT(arc("R+20 DR-").center.y(), 40);  // over the chord
  EXPECT_GT(arc("R+20 DR+").center.y(), 40);
  EXPECT_GT(arc("R-20 DR-").sweep_rad, std::numbers::pi);
  EXPECT_GT(arc("R-20 DR-").center.y(), 40);
  EXPECT_LT(arc("R-20 DR+").center.y(), 40);
  expect_open(kStart + "CR X+70 Y+40 R+20 DR+ F200\n", "no arc of this radius");
}

TEST(KlartextArcs, RunToAPolarAngle) {
  const Toolpath path = blocks_of(kStart + "CC X+10 Y+0\nCP PA+90 DR- F100\n");
  EXPECT_EQ(tips(path), "(0,0,10) (10,10,10)");
  EXPECT_NEAR(last_arc(path).sweep_rad, std::numbers::pi / 2, 1e-12);
}

TEST(KlartextArcs, AreHelicesWithAllTheirTurns) {
  const Toolpath path = blocks_of(kStart + "CC X+10 Y+0\nCP IPA-1890 IZ-5 DR- F100\n");
  EXPECT_EQ(tips(path), "(0,0,10) (10,10,5)");
  EXPECT_NEAR(last_arc(path).sweep_rad, 1890 * std::numbers::pi / 180, 1e-9);
  expect_open(kStart + "CC X+10 Y+0\nCP IPA-1890 IZ-5 DR+ F100\n", "signs of IPA and DR");
  expect_open(kStart + "CC X+10 Y+0\nCP PA+810 Z+0 DR+ F100\n", "whether PA counts the turns");
}

TEST(KlartextArcs, ContinueTheirTangent) {
  const Toolpath path = blocks_of(kStart + "L X+10 F100\nCT X+15 Y+5\nCT X+10 Y+10\nL Y+20\n");
  EXPECT_EQ(tips(path), "(0,0,10) (10,0,10) (15,5,10) (10,10,10) (10,20,10)");
  EXPECT_NEAR((path.arcs[path.moves[2].curve].center - Vec3(10, 5, 10)).norm(), 0, 1e-9);
  EXPECT_NEAR((path.arcs[path.moves[3].curve].center - Vec3(10, 5, 10)).norm(), 0, 1e-9);
  const Toolpath polar = blocks_of(kStart + "L X+10 F100\nCC X+10 Y+5\nCTP PR+5 PA+0\n");
  EXPECT_NEAR((last_arc(polar).center - Vec3(10, 5, 10)).norm(), 0, 1e-9);
  expect_open(kStart + "CT X+15 Y+5 F100\n", "direction in which CT begins");
  expect_open(kStart + "L X+10 F100\nCT X+15 Y+0\n", "in the direction");
  expect_open(kStart + "L X+10 Z+5 F100\nCT X+15 Y+5\n", "direction in which CT begins");
}

TEST(KlartextArcs, AreRefusedWithoutTheirFacts) {
  expect_open(kStart + "C X+10 Y+10 DR+ F100\n", "the pole is not known");
  expect_open(kStart + "CC X+10\nC X+10 Y+10 DR+ F100\n", "the pole is not known");
  expect_open(kStart + "CC X+10 Y+0\nC X+10 Y+10 F100\n", "no direction");
  expect_open(kStart + "CC X+10 Y+0\nC X+10 Y+10 Z+3 DR+ F100\n", "third axis");
  expect_open(kStart + "CC X+10 Y+0\nC X+10 Y+13 DR+ F100\n", "not equally far");
}

TEST(KlartextMotion, IsNotCheckedBesideRoundedCorners) {
  const Toolpath path = blocks_of(kStart + "L X+10 F100\nRND R2\nL Y+10\nL X+0\n");
  EXPECT_EQ(tips(path), "(0,0,10) open open (0,10,10)");
  EXPECT_EQ(count_open(blocks_of(kStart + "L X+10 F100\nCHF 2\nL Y+10\nL X+0\n")), 2U);
  expect_open(kStart + "L Y+5\nLBL 1\nRND R2\nL X+0\n", "RND or CHF without a motion");
}

TEST(KlartextMotion, IsNotCheckedWithRadiusCompensation) {
  const Toolpath path = blocks_of(kStart + "L X+10 RL F100\nL Y+10\nL X+0 Y+0 Z+20 R0\nL X+5\n");
  EXPECT_EQ(tips(path), "(0,0,10) open open open (5,0,20)");
  expect_open(kStart + "LN X+1 Y+2 Z+3 NX+0 NY+0 NZ+1 F100\n", "compensation in space");
}

TEST(KlartextMotion, ToTheMachineDatumNeedsThePlaceOfThePreset) {
  expect_open(kStart + "L Z-10 FMAX M91\n", "expected --offset");
  expect_open(kStart + "L Z-10 FMAX M92\n", "only the machine knows");
  GcodeOptions options;
  options.setup.offsets["PRESET"] = {Vec3(0, 0, -400), Vec3::Zero()};
  options.setup.lengths_mm[1] = 100;
  EXPECT_EQ(tips(blocks_of(kStart + "L Z-10 FMAX M91\n", options)), "(0,0,10) (0,0,290)");
}

TEST(KlartextMotion, IsLostByWordsWithoutARow) {
  for (const std::string word : {"M200", "X+1 X+2", "U+3", "R+5", "DR+", "PA+3", "F100 F200", "X", "Q5", "M3 M3",
                                 "X+1,5", "FMAXT", "R0 RL", "M89", "M98", "M101", "M144", "M94"})
    expect_open(kStart + "L " + word + "\nL X+0\n", "not understood");
  expect_open(kStart + "APPR LCT X+10 Y+20 R5 RL F100\nL X+0\n", "APPR");
  expect_open(kStart + "L X+1\nFOO X+3\nL X+0\n", "FOO");
  GcodeOptions options;
  options.harmless_words = {"M200"};
  EXPECT_EQ(count_open(blocks_of(kStart + "L X+1 F100 M200\n", options)), 0U);
}

TEST(KlartextMotion, IsNotCheckedOffThePathOfTheProgram) {
  for (const std::string word : {"M90", "M112", "M118", "M120", "M124"})
    expect_open(kStart + "L X+1 " + word + "\nL X+0\n", "by M");
  for (const std::string block : {"L M140", "L M140 MB50", "L M140 MB MAX", "L M140 MB+Q1 F100"})
    expect_open(kStart + block + "\nL X+5 Y+5\n", "place");
  expect_open(kStart + "L M140 MB\nL X+5\n", "MB");
  EXPECT_EQ(tips(blocks_of(kStart + "L M140 MB MAX\nL X+5 Y+5 Z+5 FMAX\nL X+0\n")), "(0,0,10) open open (0,5,5)");
  EXPECT_EQ(tips(blocks_of(kStart + "M6\nL X+5 Y+5 Z+5 FMAX\nL X+0\n")), "(0,0,10) open open (0,5,5)");
}

}  // namespace
}  // namespace gouge::klartext::klartext_motion_test
