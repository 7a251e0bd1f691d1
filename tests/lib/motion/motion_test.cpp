#include "lib/motion/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/motion/tool_interval.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"

namespace gouge::motion_test {
namespace {

TEST(Motion, EndsAreTheGivenPosesBitForBit) {
  test::Scatter random(3);
  for (int i = 0; i < 100; ++i) {
    const Pose a{random.point(50), random.direction()};
    const Pose b{random.point(50), random.direction()};
    const Motion motion = test::straight(a, b);
    EXPECT_EQ(motion.at(0).tip, a.tip);
    EXPECT_EQ(motion.at(1).axis, b.axis);
    EXPECT_NEAR(motion.at(0.3).axis.norm(), 1, 1e-15);
  }
}

TEST(Motion, TheAxisTurnsEvenlyOnTheGreatCircle) {
  const Motion motion = test::straight({Vec3::Zero(), Vec3::UnitZ()}, {Vec3(10, 0, 0), Vec3::UnitX()});
  const Pose third = motion.at(1.0 / 3);
  EXPECT_NEAR(third.axis.x(), 0.5, 1e-15);
  EXPECT_NEAR(third.axis.y(), 0, 1e-15);
  EXPECT_NEAR(third.tip.x(), 10.0 / 3, 1e-14);
}

TEST(Motion, OppositeAxesHaveNoDefinedWay) {
  EXPECT_FALSE(test::straight({Vec3::Zero(), Vec3::UnitZ()}, {Vec3::Zero(), -Vec3::UnitZ()}).is_defined());
  EXPECT_TRUE(
      test::straight({Vec3::Zero(), Vec3::UnitZ()}, {Vec3::Zero(), Vec3(0, 1e-3, -1).normalized()}).is_defined());
}

TEST(Motion, AxesThatDifferByRoundingDoNotTurnWildly) {
  const Vec3 axis = Vec3(0.1, 0.2, 0.97).normalized();
  const Vec3 other = (axis + Vec3(1e-16, -1e-16, 0)).normalized();
  const Motion motion = test::straight({Vec3::Zero(), axis}, {Vec3::UnitX(), other});
  for (double t = 0; t <= 1; t += 0.1) EXPECT_LT((motion.at(t).axis - axis).norm(), 1e-12);
}

TEST(Motion, DoglegRunsAllAxesAtOneSpeedUntilEachArrives) {
  const Motion motion = test::dogleg({Vec3::Zero(), Vec3::UnitZ()}, {Vec3(10, -4, 2), Vec3::UnitZ()});
  ASSERT_EQ(motion.segments().size(), 3U);
  EXPECT_TRUE(motion.at(0.2).tip.isApprox(Vec3(2, -2, 2), 1e-14));
  EXPECT_TRUE(motion.at(0.4).tip.isApprox(Vec3(4, -4, 2), 1e-14));
  EXPECT_TRUE(motion.at(0.7).tip.isApprox(Vec3(7, -4, 2), 1e-14));
  EXPECT_EQ(motion.at(1).tip, Vec3(10, -4, 2));
}

TEST(ToolInterval, FramesAgreeWithThePose) {
  test::Scatter random(5);
  for (int i = 0; i < 200; ++i) {
    const Motion motion =
        test::straight({random.point(20), random.direction()}, {random.point(20), random.direction()});
    for (const double t : {0.0, 0.123, 0.5, 0.9, 1.0}) {
      const Pose pose = motion.at(t);
      const Vec3 p = random.point(100);
      const Vec3 q = tool_frame(motion, t, 0).to_tool(p);
      const Vec3 d = p - pose.tip;
      EXPECT_NEAR(q.z(), d.dot(pose.axis), 1e-11);
      EXPECT_NEAR(q.head<2>().norm(), (d - d.dot(pose.axis) * pose.axis).norm(), 1e-11);
    }
  }
}

TEST(ToolInterval, NoPathBulgesFurtherFromItsChordThanStated) {
  test::Scatter random(11);
  double tightest = 1e300;
  for (int i = 0; i < 500; ++i) {
    const Vec3 a = random.direction();
    const Vec3 b = (a + 0.5 * random.direction()).normalized();
    const Motion motion = test::straight({random.point(5), a}, {random.point(5), b});
    ToolIntervals intervals(motion, motion);
    const std::uint32_t half = intervals.halve(0) + 1;
    const ToolInterval interval = intervals[half];
    const Vec3 p = random.point(60);
    const double stated = interval.rates.bulge_mm((p - interval.tip_middle).norm());
    const Vec3 q0 = interval.f0.to_tool(p), q1 = interval.f1.to_tool(p);
    for (double s = 0; s <= 1; s += 0.05) {
      const Vec3 q = tool_frame(motion, interval.t0 + s * (interval.t1 - interval.t0), 0).to_tool(p);
      const double bulge = (q - (q0 + s * (q1 - q0))).norm();
      EXPECT_LE(bulge, stated + 1e-12);
      if (bulge > 1e-6) tightest = std::min(tightest, stated / bulge);
    }
  }
  EXPECT_LT(tightest, 1.5);  // the bound is not merely huge
}

}  // namespace
}  // namespace gouge::motion_test
