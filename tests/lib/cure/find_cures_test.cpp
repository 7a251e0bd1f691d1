#include "lib/cure/find_cures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::find_cures_test {
namespace {

using paths::upright;

constexpr double kDegree = std::numbers::pi / 180;

/// A ball cutter D10 in a holder D32, 50 mm above the tip, along a wall 12 mm beside the tip and `wall_mm` high.
struct AlongWall {
  ToolVariants tool = tools::ball(10);
  Scene scene;
  Toolpath path;
  CureOptions cure;

  explicit AlongWall(double wall_mm) {
    scene.parts = {shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)),
                   shapes::box(Vec3(12, -30, -5), Vec3(60, 30, wall_mm))};
    std::vector<Pose> poses{upright(0, -80, 120)};
    for (double y = -80; y <= 80; y += 4) poses.push_back(upright(0, y, 0));
    poses.push_back(upright(0, 80, 120));
    path = paths::through(poses);
  }

  [[nodiscard]] std::vector<FindingCures> solve(unsigned threads = 1) const {
    CheckOptions options;
    options.threads = threads;
    const OwnSetup own(&tool, scene, options);
    return find_cures(path, check(path, own.setup), own.setup, cure);
  }
};

// The tool turns about the centre of its ball, 5 mm above the floor. Leaning away by a, the rim of the holder, 16 mm
// off the axis and 45 mm above that centre, is at x = 16 cos a - 45 sin a, below the top of the wall at x = 12.
TEST(FindCures, OfAHolderBesideAWallAreATiltAndALift) {
  const AlongWall wall(55);
  const std::vector<FindingCures> found = wall.solve();
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].lift.lift_mm);
  EXPECT_NEAR(*found[0].lift.lift_mm, 5, 0.011 + 0.01);
  ASSERT_TRUE(found[0].tilt.tilt_rad) << found[0].tilt.reason;
  double exact = 0;
  while (16 * std::cos(exact) - 45 * std::sin(exact) > 12) exact += 1e-5;
  EXPECT_NEAR(*found[0].tilt.tilt_rad, exact, 0.1 * kDegree);
}

TEST(FindCures, WhereNoTiltIsAllowedTheReasonIsGiven) {
  AlongWall wall(55);
  wall.cure.tilt.max_tilt_rad = 1 * kDegree;
  const std::vector<FindingCures> found = wall.solve();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].tilt.tilt_rad);
  EXPECT_NE(found[0].tilt.reason.find("no tilt within --max-tilt 1 degrees"), std::string::npos)
      << found[0].tilt.reason;
  EXPECT_TRUE(found[0].lift.lift_mm);
}

TEST(FindCures, OfTheCutterAreNotSought) {
  AlongWall wall(55);
  wall.scene.parts.pop_back();
  wall.path = paths::through({upright(0, -20, 20), upright(0, -20, -0.5), upright(0, 20, -0.5)});
  EXPECT_TRUE(wall.solve().empty());
}

TEST(FindCures, EachFindingHasItsOwn) {
  AlongWall wall(55);
  wall.scene.parts = {shapes::box(Vec3(-200, -400, -10), Vec3(200, 400, 0)),
                      shapes::box(Vec3(12, -130, -5), Vec3(60, -100, 53)),
                      shapes::box(Vec3(12, 100, -5), Vec3(60, 130, 58))};
  std::vector<Pose> poses{upright(0, -200, 120)};
  for (double y = -200; y <= 200; y += 4) poses.push_back(upright(0, y, 0));
  wall.path = paths::through(poses);
  const std::vector<FindingCures> found = wall.solve();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(*found[0].lift.lift_mm, 3, 0.03);
  EXPECT_NEAR(*found[1].lift.lift_mm, 8, 0.03);
  ASSERT_TRUE(found[0].tilt.tilt_rad && found[1].tilt.tilt_rad);
  EXPECT_LE(*found[0].tilt.tilt_rad, *found[1].tilt.tilt_rad + 0.03 * kDegree);
}

TEST(FindCures, AreTheSameAtAnyNumberOfThreads) {
  const AlongWall wall(56);
  const std::vector<FindingCures> one = wall.solve(1), three = wall.solve(3);
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(three.size(), 1U);
  EXPECT_EQ(one[0].lift.lift_mm, three[0].lift.lift_mm);
  EXPECT_EQ(one[0].lift.move, three[0].lift.move);
  EXPECT_EQ(one[0].tilt.tilt_rad, three[0].tilt.tilt_rad);
}

}  // namespace
}  // namespace gouge::find_cures_test
