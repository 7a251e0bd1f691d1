// Cases that programmers know: each as a person would judge it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/path/path_info.h"
#include "tests/lib/tilt/tilt_bench.h"

namespace gouge::tilt_cases_test {
namespace {

using namespace tilt_bench;

/// A box whose upper parts stand further in X.
IndexedMesh leaning_box(const Vec3& low, const Vec3& high, double dx_per_mm) {
  IndexedMesh mesh = shapes::box(low, high);
  for (Vec3& p : mesh.vertices) p.x() += dx_per_mm * (p.z() - low.z());
  return mesh;
}

/// For a record on the row, away from its ends.
double largest_turn(const Toolpath& path) {
  double most = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i)
    if (std::abs(path.moves[i].end.tip.y()) < 40)
      most = std::max(most, angle_between_rad(path.moves[i - 1].end.axis, path.moves[i].end.axis));
  return most;
}

// Both walls of a slot lean by 20 degrees: upright the shank is in one of them; along them it is free, with 2 mm of room
// on either side of the ball.
TEST(TiltCases, InASlotBetweenLeaningWallsTheToolLeansWithThem) {
  const double slope = std::tan(20 * kDegree);
  ToolAssembly tool = long_ball();
  tool.cutter = BallCutter{10, 7};
  tool.shank = {{8, 8, 60}};
  const Bench bench(row(-40, 40, 5),
                    {floor_plate(), leaning_box(Vec3(6.5, -12, 0), Vec3(30, 12, 50), slope),
                     leaning_box(Vec3(-30, -12, 0), Vec3(-6.5 - 5 * slope, 12, 50), slope)},
                    tool);
  ASSERT_GT(bench.before.counts.gouge, 0U);
  const TiltPlan plan = bench.plan();
  expect_clean(bench, plan);
  for (const TiltedPosition& p : positions_of(plan)) {
    if (p.programmed.tip.z() > 0 || std::abs(p.programmed.tip.y()) > 10) continue;
    EXPECT_GT(p.pose.axis.x(), std::sin(8 * kDegree));
    EXPECT_LT(p.pose.axis.x(), std::sin(30 * kDegree));
  }
}

// The holder is free at both positions, 80 mm apart, and in a post between them.
TEST(TiltCases, PastAPostBetweenTwoFreePositionsItLeansAndComesBack) {
  const Bench bench({upright(0, -40, 120), upright(0, -40, 0), upright(0, 40, 0), upright(0, 40, 120)},
                    {floor_plate(), shapes::box(Vec3(9, -2, -5), Vec3(13, 2, 90))});
  ASSERT_EQ(bench.before.counts.gouge, 1U);
  const TiltPlan plan = bench.plan();
  expect_clean(bench, plan);
  for (const TiltedPosition& p : positions_of(plan)) EXPECT_EQ(p.move, 2U);
  const Toolpath path = bench.tilted(plan);
  EXPECT_GT(path.moves.size(), bench.path.moves.size());
  for (const std::size_t i : {std::size_t{1}, path.moves.size() - 2}) EXPECT_EQ(path.moves[i].end.axis, Vec3::UnitZ());
  // A holder that is free beside the post leans by no more than one that is free beside a wall there.
  EXPECT_LT(largest_tilt(plan), min_tilt(9) + 0.2 * kDegree);
}

// The programmed axis goes from 15 degrees on one side through Z to 15 on the other, where the rotary axis of a table
// has its pole and lead and tilt angles about Z have no meaning. Beside it stands a wall.
TEST(TiltCases, AcrossThePoleOfARotaryAxisTheTiltIsAsSmoothAsElsewhere) {
  const auto fan = [](double lean) {
    std::vector<Pose> poses{upright(0, -60, 120)};
    for (int k = -30; k <= 30; ++k) {
      const double angle = lean * k / 30 * kDegree;
      const Vec3 axis(0, std::sin(angle), std::cos(angle));
      poses.push_back({Vec3(0, 2 * k, 5) - 5 * axis, axis});
    }
    poses.push_back(upright(0, 60, 120));
    return poses;
  };
  const std::vector<IndexedMesh> parts{floor_plate(), shapes::box(Vec3(9, -100, -5), Vec3(60, 100, 90))};
  const Bench across(fan(15), parts), upright_all(fan(0), parts);
  const TiltPlan plan = across.plan(), usual = upright_all.plan();
  expect_clean(across, plan);
  expect_clean(upright_all, usual);
  EXPECT_LT(largest_tilt(plan), largest_tilt(usual) + 1 * kDegree);
  EXPECT_LT(largest_turn(across.tilted(plan)), largest_turn(upright_all.tilted(usual)) + 2 * kDegree);
}

// A bull-nose touches a slope of 30 degrees with its corner: tilted the corner keeps touching it at the same point, so
// the tip moves as the corner's centre turns.
TEST(TiltCases, ABullNoseOnASlopeKeepsItsPointOnTheSlope) {
  ToolAssembly tool = long_ball();
  tool.cutter = BullNoseCutter{12, 3, 20};
  const double slope = 30 * kDegree;
  const Vec3 normal(-std::sin(slope), 0, std::cos(slope));
  // The corner's centre is 3 mm above the tip and 3 mm beside the axis; its ring's lowest point against the slope is
  // uphill, at +X.
  const double lift = (3 - normal.z() * 3 + 3 * std::abs(normal.x())) / normal.z();
  std::vector<Pose> poses{upright(0, -60, 120)};
  for (double y = -60; y <= 60; y += 4) poses.push_back(upright(0, y, lift));
  poses.push_back(upright(0, 60, 120));
  IndexedMesh wedge = shapes::box(Vec3(-100, -100, -10), Vec3(100, 100, 0));
  for (Vec3& p : wedge.vertices)
    if (p.z() > -1) p.z() = std::tan(slope) * p.x();
  for (Vec3& p : wedge.vertices)
    if (p.z() < -9 && p.z() > -11) p.z() = -80;
  const Bench bench(poses, {wedge, shapes::box(Vec3(-60, -20, 20), Vec3(-10, 20, 90))}, tool);
  ASSERT_GT(bench.before.counts.gouge, 0U);
  TiltOptions options;
  options.max_stock_mm = 5;
  const TiltPlan plan = bench.plan(options);
  expect_clean(bench, plan);
  std::size_t touching = 0;
  for (const TiltedPosition& p : positions_of(plan)) {
    if (p.programmed.tip.z() > 50 || !(p.tilt_rad > 1 * kDegree)) continue;
    // How near the slope's plane the tilted cutter comes: 0, as programmed, unless it had to rise.
    const Vec3 across = normal - normal.dot(p.pose.axis) * p.pose.axis;
    const double reach = normal.dot(p.pose.tip + 3 * p.pose.axis) - 3 * across.norm() - 3;
    EXPECT_GT(reach, -0.011);
    EXPECT_LT(reach, 0.011);
    ++touching;
  }
  EXPECT_GT(touching, 5U);
}

}  // namespace
}  // namespace gouge::tilt_cases_test
