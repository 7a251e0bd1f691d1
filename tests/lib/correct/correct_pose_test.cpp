#include "lib/correct/correct_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::correct_pose_test {
namespace {

constexpr double kAim_mm = 0.005;
constexpr double kMargin_mm = 0.002;  // how much further than the aim the weighted shift reaches

PoseLimits limits(double largest_shift = 20) {
  PoseLimits all;
  all.aim = {kAim_mm, kAim_mm, -0.002};
  all.largest_shift_mm = largest_shift;
  return all;
}

/// A triangle in the plane through the origin with this normal, its corners far away.
IndexedMesh plane(const Vec3& normal) {
  const Vec3 n = normal.normalized();
  const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
  IndexedMesh mesh;
  mesh.vertices = {-60 * u - 40 * v, 60 * u - 45 * v, 90 * v};
  shapes::add_triangle(mesh, 0, 1, 2);
  return mesh;
}

double depth_of(const Pose& pose, const ToolVariants& tool, const Scene& scene) {
  CheckOptions exact;
  exact.resolution_mm = 1e-5;
  exact.tolerance_mm = 0;
  return OwnSetup(&tool, scene, exact).checker().check(MotionLaw::tool_at(pose), MoveKind::feed, tool, exact).depth_mm;
}

// Thesis figure 35: a circle in a V. Each of two contacts is d deep; by symmetry the shift is d (n1 + n2) / 2,
// which leaves d' = d (1 - n1 . (n1 + n2) / 2) = d (1 - n1 . n2) / 2. The excess over aim - room falls by this
// factor with each iteration, until it is no more than the room.
struct Vee {
  double between_normals_deg;
  double depth_mm;

  friend void PrintTo(const Vee& vee, std::ostream* out) {
    *out << vee.between_normals_deg << " degrees, " << vee.depth_mm << " mm";
  }
};

class BallInAVee : public ::testing::TestWithParam<Vee> {};

INSTANTIATE_TEST_SUITE_P(Angles, BallInAVee,
                         ::testing::Values(Vee{90, 0.3}, Vee{90, 0.05}, Vee{60, 0.3}, Vee{30, 1.0}, Vee{110, 0.2}),
                         [](const auto& test) { return "Case" + std::to_string(test.index); });

TEST_P(BallInAVee, ConvergesAsTheFormulaSaysAndEndsWithinTheAim) {
  const double half = GetParam().between_normals_deg / 2 * M_PI / 180;
  const Vec3 n1(std::sin(half), 0, std::cos(half)), n2(-std::sin(half), 0, std::cos(half));
  const Scene scene{{plane(n1), plane(n2)}, {}};
  constexpr double kRadius = 5;
  // The centre of the ball stands radius - depth away from both planes.
  const double center = (kRadius - GetParam().depth_mm) / std::cos(half);
  const Pose pose{Vec3(0, 0, center - kRadius), Vec3::UnitZ()};
  const auto corrected = correct_weighted(pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits());
  ASSERT_TRUE(corrected.has_value());
  const double factor = (1 - n1.dot(n2)) / 2;
  const double excess = GetParam().depth_mm - kAim_mm + kMargin_mm;
  const double expected = std::ceil(std::log(excess / kMargin_mm) / -std::log(factor));
  // Contacts are reported a tenth too shallow at most, which costs an iteration or two.
  EXPECT_GE(corrected->iterations, expected - 1);
  EXPECT_LE(corrected->iterations, std::ceil(expected * 1.15) + 1);
  EXPECT_LE(depth_of(corrected->pose, tools::ball(), scene), kAim_mm + 2e-4);
  const double least = (GetParam().depth_mm - kAim_mm) / std::cos(half);
  EXPECT_GE(corrected->shift_mm, least - 5e-4);
  EXPECT_LE(corrected->shift_mm, least + kMargin_mm / std::cos(half) + 1e-6);
  EXPECT_NEAR((corrected->pose.tip - pose.tip).norm(), corrected->shift_mm, 1e-12);
  EXPECT_NEAR(corrected->pose.tip.y(), 0, 0.01);
  EXPECT_EQ(corrected->pose.axis, pose.axis);
  EXPECT_EQ(corrected->strategy, Strategy::weighted);
}

TEST(Weighted, APlaneTakesOneOrTwoIterations) {
  const Scene scene{{plane(Vec3(0.3, -0.2, 1))}, {}};
  const Vec3 n = Vec3(0.3, -0.2, 1).normalized();
  const Vec3 center = (5 - 0.4) * n;
  const Pose pose{center - 5 * Vec3::UnitZ(), Vec3::UnitZ()};
  const auto corrected = correct_weighted(pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits());
  ASSERT_TRUE(corrected.has_value());
  EXPECT_LE(corrected->iterations, 2);
  EXPECT_NEAR(corrected->shift_mm, 0.4 - kAim_mm, 2 * kMargin_mm);
  EXPECT_NEAR(((corrected->pose.tip - pose.tip).normalized() - n).norm(), 0, 1e-6);
}

TEST(Weighted, ATooNarrowSlotIsGivenUpWhereTheAxisLeadsOut) {
  const Scene slot{
      {shapes::box(Vec3(-40, -40, -20), Vec3(-4.5, 40, 0)), shapes::box(Vec3(4.5, -40, -20), Vec3(40, 40, 0))}, {}};
  const Pose pose{Vec3(0, 0, -3), Vec3::UnitZ()};
  const ToolVariants flat = tools::flat();
  EXPECT_FALSE(correct_weighted(pose, flat, OwnSetup(nullptr, slot).checker(), limits()).has_value());
  const auto lifted = correct_as(Strategy::axis, pose, flat, OwnSetup(nullptr, slot).checker(), limits());
  ASSERT_TRUE(lifted.has_value());
  EXPECT_EQ(lifted->strategy, Strategy::axis);
  EXPECT_NEAR(lifted->pose.tip.z(), 0, 0.006);
}

TEST(AlongAxis, OnAPlaneItIsTheAnalyticLift) {
  for (const double lean_deg : {0.0, 10.0, 35.0, 60.0}) {
    const double lean = lean_deg * M_PI / 180;
    const Vec3 axis(std::sin(lean), 0, std::cos(lean));
    const double depth = 0.3;
    const Vec3 center(0, 0, 5 - depth);
    const Scene scene{{plane(Vec3::UnitZ())}, {}};
    const Pose pose{center - 5 * axis, axis};
    const auto lifted = correct_along_axis(pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits());
    ASSERT_TRUE(lifted.has_value()) << lean_deg;
    const double exact = (depth - kAim_mm) / std::cos(lean);
    EXPECT_GE(lifted->shift_mm, exact - 2.1e-4 / std::cos(lean)) << lean_deg;
    EXPECT_LE(lifted->shift_mm, exact + 1.001e-3) << lean_deg;
    EXPECT_NEAR((lifted->pose.tip - pose.tip).cross(axis).norm(), 0, 1e-12);
    EXPECT_EQ(lifted->pose.axis, axis);
  }
}

TEST(AlongAxis, AFlatCutterLeansOnItsRim) {
  // A flat cutter leaning by a, its lowest rim point d below the plane: its axis must rise by (d - aim) / cos a.
  const double lean = 20 * M_PI / 180;
  const Vec3 axis(std::sin(lean), 0, std::cos(lean));
  const Pose pose{Vec3(0, 0, 5 * std::sin(lean) - 0.2), axis};
  const Scene scene{{plane(Vec3::UnitZ())}, {}};
  const auto lifted = correct_along_axis(pose, tools::flat(), OwnSetup(nullptr, scene).checker(), limits());
  ASSERT_TRUE(lifted.has_value());
  // Near the rim the depth of a point is less than its distance to the rim's lowest point, so the aim is met a
  // little earlier than the plane is left.
  EXPECT_LE(lifted->shift_mm, 0.2 / std::cos(lean) + 1.001e-3);
  EXPECT_GE(lifted->shift_mm, (0.2 - 4 * kAim_mm) / std::cos(lean));
  EXPECT_LE(depth_of(lifted->pose, tools::flat(), scene), kAim_mm + 2e-4);
}

TEST(AlongNormal, OfAPlaneIsTheShortestWayOut) {
  const Vec3 n = Vec3(0.3, -0.2, 1).normalized();
  const Scene scene{{plane(n)}, {}};
  // A ball whose centre is 4.7 mm above the plane.
  const Pose pose{4.7 * n - 5 * Vec3::UnitZ(), Vec3::UnitZ()};
  const auto corrected = correct_along_normal(pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits());
  ASSERT_TRUE(corrected.has_value());
  EXPECT_NEAR(corrected->shift_mm, 0.3 - kAim_mm + kMargin_mm, 1e-6);
  EXPECT_NEAR(((corrected->pose.tip - pose.tip).normalized() - n).norm(), 0, 1e-6);
  EXPECT_EQ(corrected->iterations, 1);
}

TEST(AlongDirection, GoesThatWayAndNoFurtherThanItMust) {
  const Vec3 n = Vec3(0.3, -0.2, 1).normalized();
  const Scene scene{{plane(n)}, {}};
  const Pose pose{4.7 * n - 5 * Vec3::UnitZ(), Vec3::UnitZ()};
  PoseLimits along = limits();
  along.direction = Vec3(1, 0, 1).normalized();
  const auto corrected = correct_along_direction(pose, tools::ball(), OwnSetup(nullptr, scene).checker(), along);
  ASSERT_TRUE(corrected.has_value());
  EXPECT_GT((corrected->pose.tip - pose.tip).normalized().dot(along.direction), 1 - 1e-9);
  EXPECT_NEAR(corrected->shift_mm, (0.3 - kAim_mm) / along.direction.dot(n), 0.01);
}

TEST(Limits, AShiftBeyondTheLargestIsNoCorrection) {
  const Scene scene{{plane(Vec3::UnitZ())}, {}};
  const Pose pose{Vec3(0, 0, -0.3), Vec3::UnitZ()};
  for (const Strategy strategy : {Strategy::weighted, Strategy::axis, Strategy::normal, Strategy::direction}) {
    EXPECT_FALSE(
        correct_as(strategy, pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits(0.25)).has_value());
    const auto corrected = correct_as(strategy, pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits(0.31));
    ASSERT_TRUE(corrected.has_value());
    EXPECT_LE(corrected->shift_mm, 0.31);
  }
}

TEST(Limits, APoseThatMeetsTheAimStaysBitForBit) {
  const Scene scene{{plane(Vec3::UnitZ())}, {}};
  const Pose pose{Vec3(0.1, 0.2, -0.004), Vec3::UnitZ()};
  for (const Strategy strategy : {Strategy::weighted, Strategy::axis, Strategy::normal, Strategy::direction}) {
    const auto corrected = correct_as(strategy, pose, tools::ball(), OwnSetup(nullptr, scene).checker(), limits());
    ASSERT_TRUE(corrected.has_value());
    EXPECT_EQ(corrected->pose.tip, pose.tip);
    EXPECT_EQ(corrected->iterations, 0);
    EXPECT_EQ(corrected->shift_mm, 0);
  }
}

TEST(Strategies, HaveTheNamesOfTheCommandLine) {
  EXPECT_STREQ(strategy_name(Strategy::weighted), "weighted");
  EXPECT_STREQ(strategy_name(Strategy::axis), "axis");
  EXPECT_STREQ(strategy_name(Strategy::tilt), "tilt");
  EXPECT_STREQ(strategy_name(Strategy::normal), "normal");
  EXPECT_STREQ(strategy_name(Strategy::direction), "direction");
  EXPECT_STREQ(strategy_name(Strategy::trim), "trim");
}

}  // namespace
}  // namespace gouge::correct_pose_test
