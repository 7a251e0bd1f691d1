// No shift leads across the surface.
#include "lib/correct/correct_pose.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::free_pose_test {
namespace {

using paths::upright;

struct Case {
  ToolVariants tool = tools::ball();
  Scene scene;
  CheckOptions options;

  [[nodiscard]] const char* why_not(const Pose& from, const Pose& to) const {
    return why_not_shift(from, to, MoveKind::feed, tool, OwnSetup(&tool, scene, options).checker());
  }
};

Case over_a_block() {
  Case c;
  c.scene.parts = {shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 0))};
  return c;
}

TEST(Shift, OutOfTheSurfaceIsAllowed) {
  const Case c = over_a_block();
  EXPECT_EQ(c.why_not(upright(0, 0, -0.3), upright(0, 0, 0)), nullptr);
  EXPECT_EQ(c.why_not(upright(0, 0, 1), upright(0, 0, 5)), nullptr);
}

TEST(Shift, DeeperIntoItIsNot) {
  const Case c = over_a_block();
  EXPECT_NE(c.why_not(upright(0, 0, -0.3), upright(0, 0, -0.4)), nullptr);
}

TEST(Shift, ThroughAWallIsNotThoughBothItsEndsAreAsDeep) {
  Case c;
  c.scene.parts = {shapes::box(Vec3(-0.5, -50, -20), Vec3(0.5, 50, 20))};
  const Pose left = upright(-5.3, 0, 0), right = upright(5.3, 0, 0);
  const char* reason = c.why_not(left, right);
  ASSERT_NE(reason, nullptr);
  EXPECT_NE(std::string(reason).find("through the surface"), std::string::npos) << reason;
}

// The surface leaves the tool because all of it is in the solid then: no depth any more, and buried.
TEST(Shift, OnIntoTheSolidIsNotThoughTheDepthFallsToNothing) {
  Case c = over_a_block();
  c.tool = tools::variants([] {
    ToolAssembly tool;
    tool.cutter = BallCutter{10, 12};
    return tool;
  }());
  const char* reason = c.why_not(upright(0, 0, -10), upright(0, 0, -30));
  ASSERT_NE(reason, nullptr);
  EXPECT_NE(std::string(reason).find("into the solid"), std::string::npos) << reason;
}

// As deep as the middle of the cutter, where the depth is the radius all the way up.
TEST(Shift, ALongLiftOfASunkenToolIsAllowed) {
  Case c = over_a_block();
  c.tool = tools::flat();
  EXPECT_EQ(c.why_not(upright(0, 0, -12), upright(0, 0, 0)), nullptr);
}

TEST(FreePose, ASidewaysWayOutBeyondTheLimitGivesWayToALift) {
  Case c;
  c.tool = tools::flat();
  c.scene.parts = {shapes::box(Vec3(0, -50, -20), Vec3(40, 50, 3))};  // its wall at x = 0
  const Pose pose = upright(-4.6, 0, 0);                              // 0.4 mm in the wall
  const OwnSetup own(&c.tool, c.scene, c.options);
  const MotionChecker checker = own.checker();
  PoseLimits limits;
  limits.aim = {0.005, -0.002, -0.002};
  const double depth = checker.measure(pose, MoveKind::feed, c.tool).depth_mm;
  EXPECT_NEAR(depth, 0.4, 0.001);
  const auto freed = [&](const std::optional<double>& side) {
    return free_pose(Strategy::weighted, pose, depth, MoveKind::feed, c.tool, checker, limits, side);
  };
  const FreedPose aside = freed(std::nullopt);
  ASSERT_TRUE(aside.corrected.has_value());
  EXPECT_EQ(aside.corrected->strategy, Strategy::weighted);
  EXPECT_NEAR(aside.corrected->pose.tip.x(), -5, 0.01);
  const FreedPose up = freed(0.1);
  ASSERT_TRUE(up.corrected.has_value());
  EXPECT_EQ(up.corrected->strategy, Strategy::axis);
  EXPECT_NEAR(up.corrected->pose.tip.z(), 3, 0.01);
  limits.largest_shift_mm = 1;
  const FreedPose none = freed(0.1);
  EXPECT_FALSE(none.corrected.has_value());
  EXPECT_EQ(
      none.reason,
      "the way out leads sideways, away from the programmed cut, by 0.398 mm, more than --max-side-shift allows: 0.1 "
      "mm");
}

/// A flat cutter of 10 mm, 30 mm long, whose shank is `shank` wide, beside a wall at x = 0 of the given height.
struct BesideAWall {
  ToolVariants tool;
  Scene scene;
  CheckOptions options;
  PoseLimits limits;

  BesideAWall(double shank, double bottom, double top)
      : tool(tools::variants(tools::assembly(FlatCutter{10, 30}, shank))) {
    scene.parts = {shapes::box(Vec3(0, -50, bottom), Vec3(40, 50, top))};
    limits.aim = {0.005, -0.002, -0.002};
    limits.of_cutter = Strategy::normal;
  }

  [[nodiscard]] FreedPose freed(const Pose& pose) const {
    const OwnSetup own(&tool, scene, options);
    const MotionChecker checker = own.checker();
    const double depth = checker.measure(pose, MoveKind::feed, tool).depth_mm;
    return free_pose(Strategy::tilt, pose, depth, MoveKind::feed, tool, checker, limits, std::nullopt);
  }
  [[nodiscard]] std::string longer(const Pose& pose) const {
    const OwnSetup own(&tool, scene, options);
    return longer_lift(pose, MoveKind::feed, tool, own.checker(), limits);
  }
};

TEST(FreePose, WhereTheCutterGougesTooADeeperShankDoesNotKeepItFromItsShift) {
  const BesideAWall wall(10.4, -20, 45);
  const FreedPose freed = wall.freed(upright(-4.6, 0, 0));  // the cutter 0.4 mm in the wall, the shank 0.6 mm
  ASSERT_TRUE(freed.corrected.has_value()) << freed.reason;
  EXPECT_EQ(freed.corrected->strategy, Strategy::normal);
  EXPECT_NEAR(freed.corrected->pose.tip.x(), -5.2, 0.01);
}

TEST(FreePose, AShankAloneIsLiftedAndShiftedOnlyWhereNoLiftFreesIt) {
  const Pose pose = upright(-5, 0, 0);
  BesideAWall wall(10.4, 25, 38);  // the cutter touches, the shank is 0.2 mm in it
  const FreedPose lifted = wall.freed(pose);
  ASSERT_TRUE(lifted.corrected.has_value());
  EXPECT_EQ(lifted.corrected->strategy, Strategy::axis);
  wall.limits.largest_shift_mm = 5;
  const FreedPose shifted = wall.freed(pose);
  ASSERT_TRUE(shifted.corrected.has_value()) << shifted.reason;
  EXPECT_EQ(shifted.corrected->strategy, Strategy::normal);
  wall.limits.of_cutter.reset();
  const FreedPose left = wall.freed(pose);
  EXPECT_FALSE(left.corrected.has_value());
  EXPECT_EQ(left.reason, "no way out within --max-shift 5 mm");
}

TEST(FreePose, AReasonNamesTheLimitsThatWouldFreeThePose) {
  BesideAWall wall(10.4, 25, 38);
  wall.limits.largest_shift_mm = 0.1;
  const FreedPose left = wall.freed(upright(-5, 0, 0));
  EXPECT_EQ(left.reason,
            "no way out within --max-shift 0.1 mm, neither along the tool axis nor as a shift of the cutter");
  wall.limits.largest_shift_mm = 2;
  EXPECT_EQ(wall.longer(upright(-5, 0, 0)),
            "; a lift of 7.996 mm along the tool axis would free it: --max-shift 7.996 mm");
  wall.limits.largest_shift_mm = 0.5;
  EXPECT_EQ(wall.longer(upright(-5, 0, 0)), "") << "it is longer than any that is named";
}

}  // namespace
}  // namespace gouge::free_pose_test
