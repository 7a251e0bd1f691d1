// Fields of Mastercam NCI read in the right way and in the wrong one: the part distinguishes the two.
#include <gtest/gtest.h>

#include <string>

#include "postproc/formats/read_toolpath.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::nci_readings_test {
namespace {

Toolpath read(const std::string& text, bool is_centre = false) {
  ReadOptions options;
  options.is_cutcom_centre = is_centre;
  ReadOutcome outcome = read_toolpath("a.nci", text, options);
  for (const Diagnostic& error : outcome.errors) ADD_FAILURE() << to_text(error);
  if (!outcome.toolpath) return {};
  outcome.toolpath->tools.resize(1);
  for (Move& move : outcome.toolpath->moves) move.tool = 0;
  return std::move(*outcome.toolpath);
}

/// "clean", or the state of the first move that is not.
std::string verdict(const Toolpath& path, const IndexedMesh& part, const ToolVariants& tool) {
  Scene scene;
  scene.parts.push_back(part);
  for (const MoveVerdict& v : whole_check(path, &tool, scene, {}).verdicts) {
    if (v.state != MoveState::clean) return state_name(v.state);
  }
  return "clean";
}

IndexedMesh post(const Vec3& at, double half_height) {
  return shapes::box(at - Vec3(0.1, 0.1, half_height), at + Vec3(0.1, 0.1, half_height));
}

// A quarter of a circle; the post stands in the middle of the other three.
TEST(NciReading, ArcsOfCode3AreCounterClockwise) {
  const std::string start = "0\n0 20. 0. 0. -2. 0\n", quarter = " 0. 20. 0. 0. 0. 300. 0 0\n";
  const IndexedMesh part = post({-14.14, -14.14, 0}, 5);
  for (const char* plane : {"0 0", "0 40", "40 0"}) {
    EXPECT_EQ(verdict(read(start + "3\n" + plane + quarter), part, tools::ball(1)), "clean") << plane;
    EXPECT_EQ(verdict(read(start + "2\n" + plane + quarter), part, tools::ball(1)), "gouge") << plane;
  }
}

TEST(NciReading, ArcsOfCode2AreClockwiseAboutXInTheYzPlane) {
  const std::string start = "0\n0 0. -20. 0. -2. 0\n", quarter = " 0. 20. 0. 0. 0. 300. 0 0\n";
  // From -y up to +z; the other way leads down and past +y.
  const IndexedMesh part = post({0, 14.14, -14.14}, 0.5);
  for (const char* plane : {"1 0", "0 1", "40 1", "1 40"}) {
    EXPECT_EQ(verdict(read(start + "2\n" + plane + quarter), part, tools::ball(1)), "clean") << plane;
    EXPECT_EQ(verdict(read(start + "3\n" + plane + quarter), part, tools::ball(1)), "gouge") << plane;
  }
}

// Which way an arc of the XZ plane runs no source states: either way a post may stand in it.
TEST(NciReading, ArcsOfTheXzPlaneAreNotChecked) {
  const std::string start = "0\n0 20. 0. 0. -2. 0\n";
  const IndexedMesh far = post({500, 500, 0}, 5);
  for (const char* code : {"2", "3"})
    EXPECT_EQ(verdict(read(start + code + "\n2 0 -20. 0. 0. 0. 0. 300. 0 0\n"), far, tools::ball(1)), "not-checked");
}

// Without the flag a thousandth of a millimetre is next to nothing; with it the tool goes all the way round.
TEST(NciReading, AFullCircleGoesRound) {
  const std::string start = "0\n0 20. 0. 0. -2. 0\n", end = "3\n0 0 20. .001 0. 0. 0. 300. 0";
  const IndexedMesh part = post({-20, 0, 0}, 5);
  EXPECT_EQ(verdict(read(start + end + " 1\n"), part, tools::ball(1)), "gouge");
  EXPECT_EQ(verdict(read(start + end + " 0\n"), part, tools::ball(1)), "not-checked");
}

// Along y with the wall to the left: the numbers are the wall's, and the control shifts the cutter away from
// it, or into a second wall, by a radius the file does not state.
TEST(NciReading, CompensatedPositionsAreNotTheCutterCentre) {
  const std::string start = "0\n0 0. 0. 5. -2. 0\n1\n0 0. 0. 0. 300. 0\n", way = " 0. 60. 0. -1. 0\n";
  const IndexedMesh wall = shapes::box({-12, 20, -5}, {-7, 50, 20});  // 2 mm beside a cutter of 10
  const ToolVariants tool = tools::flat(10);
  EXPECT_EQ(verdict(read(start + "1\n0" + way), wall, tool), "clean");
  for (const char* side : {"41", "42"}) {
    const std::string text = start + "1\n" + side + way;
    EXPECT_EQ(verdict(read(text), wall, tool), "not-checked") << side;
    EXPECT_EQ(verdict(read(text, true), wall, tool), "clean") << side;
  }
  Toolpath left = read(start + "1\n41" + way, true);  // where the control takes it
  for (Move& move : left.moves) move.end.tip.x() -= 5;
  EXPECT_EQ(verdict(left, wall, tool), "gouge");
}

// The tool leans away from a wall, its axis towards the second point. Read as a vector the same numbers lean
// it into the wall.
TEST(NciReading, FiveAxesHaveASecondPointNotAVector) {
  const std::string text = "11\n60. 0. 30. 42. 0. 54. 300. 0 0 0. 0. 1.\n11\n60. 9. 30. 42. 9. 54. 300. 0 0 0. 0. 1.\n";
  const IndexedMesh wall = shapes::box({66, -20, 10}, {110, 30, 120});
  const ToolVariants tool = tools::ball(8);
  const Toolpath path = read(text);
  EXPECT_EQ(verdict(path, wall, tool), "clean");
  const Vec3 as_vector = Vec3(42, 0, 54).normalized(), downwards(0.6, 0, -0.8), as_normal(0, 0, 1);
  for (const Vec3& axis : {as_vector, downwards, as_normal}) {
    Toolpath wrong = path;
    for (Move& move : wrong.moves) move.end.axis = axis;
    EXPECT_EQ(verdict(wrong, wall, tool), "gouge") << axis.transpose();
  }
}

// Flags that switch compensation leave nothing after them clean.
TEST(NciReading, FlagsThatMayCompensateAreNotPassedOver) {
  const IndexedMesh far = post({500, 500, 0}, 5);
  const std::string after = "11\n4. 0. 0. 4. 0. 1. 9. 0 0\n11\n5. 0. 0. 5. 0. 1. 9. 0 0\n";
  EXPECT_EQ(verdict(read("11\n0. 0. 0. 0. 0. 1. 9. 0 1100\n" + after), far, tools::ball(1)), "clean");
  const Toolpath path = read("11\n0. 0. 0. 0. 0. 1. 9. 0 200\n" + after);
  for (const Move& move : path.moves) EXPECT_FALSE(move.not_checked_reason.empty());
}

}  // namespace
}  // namespace gouge::nci_readings_test
