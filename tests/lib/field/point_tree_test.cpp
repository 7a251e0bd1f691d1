#include "lib/field/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/field/point_depths.h"

namespace gouge::point_tree_test {
namespace {

/// Points of a wavy surface, some of them twice.
std::vector<Vec3> wavy_points(std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i - i % 7);
    points.emplace_back(20 * std::sin(0.37 * k), 15 * std::cos(0.61 * k), std::sin(0.05 * k));
  }
  return points;
}

PointTree tree_over(const std::vector<Vec3>& points) {
  return PointTree(points.size(), [&](std::size_t i) { return points[i]; });
}

TEST(PointTree, HoldsEveryPointOnceInLeavesOfTheirBoxes) {
  for (const std::size_t count : {0U, 1U, 16U, 17U, 1000U, 5000U}) {
    const std::vector<Vec3> points = wavy_points(count);
    const PointTree tree = tree_over(points);
    EXPECT_EQ(tree.nodes().empty(), count == 0);
    std::vector<int> in_leaves(count, 0);
    for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
      const PointTree::Node& node = tree.nodes()[n];
      for (std::size_t i = node.first; i < node.last; ++i) {
        EXPECT_TRUE(node.box.contains(points[i]));
        EXPECT_LE((points[i] - node.centre).norm(), node.radius * (1 + 1e-12));
        EXPECT_LE(std::abs(node.normal.dot(points[i] - node.centre)), node.off_mm + 1e-12);
      }
      if (node.child == 0) {
        EXPECT_LE(node.last - node.first, PointTree::kLeafPoints);
        for (std::size_t i = node.first; i < node.last; ++i) ++in_leaves[i];
      } else {
        ASSERT_GT(node.child, n);
        EXPECT_EQ(tree.nodes()[node.child].first, node.first);
        EXPECT_EQ(tree.nodes()[node.child].last, tree.nodes()[node.child + 1].first);
        EXPECT_EQ(tree.nodes()[node.child + 1].last, node.last);
      }
    }
    EXPECT_EQ(std::count(in_leaves.begin(), in_leaves.end(), 1), static_cast<std::ptrdiff_t>(count));
  }
}

TEST(PointTree, BoundsHowFarItsPointsReachInAnyDirection) {
  std::vector<Vec3> points;
  for (int k = 0; k < 4000; ++k) points.emplace_back(0.1 * (k % 64), 0.003 * k, 0.2 * std::sin(0.01 * k));
  const PointTree tree = tree_over(points);
  double min_share = 1;
  for (const PointTree::Node& node : tree.nodes()) {
    for (int d = 0; d < 20; ++d) {
      const Vec3 direction = Vec3(std::sin(d), std::cos(1.7 * d), 0.3 * d - 3).normalized();
      const double bound = PointTree::reach_mm(node, direction);
      double reach = 0;
      for (std::size_t i = node.first; i < node.last; ++i)
        reach = std::max(reach, direction.dot(points[i] - node.centre));
      EXPECT_LE(reach, bound + 1e-12);
      if (node.radius > 0) min_share = std::min(min_share, bound / node.radius);
    }
  }
  EXPECT_LT(min_share, 0.6) << "along the surface's normal it is much less than the radius";
}

TEST(PointTree, IsCutIntoBlocksThatShareNoPoint) {
  const PointTree tree = tree_over(wavy_points(5000));
  std::vector<int> in_blocks(5000, 0);
  std::size_t blocks = 0;
  for (const PointTree::Node& node : tree.nodes()) {
    if (!node.is_block) continue;
    ++blocks;
    for (std::size_t i = node.first; i < node.last; ++i) ++in_blocks[i];
  }
  EXPECT_GT(blocks, 30U);
  EXPECT_EQ(std::count(in_blocks.begin(), in_blocks.end(), 1), 5000);
}

/// A ball whose inside is as deep as it is far from its surface, or several nearly at one place.
struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
  std::uint32_t parts = 0, first_part = 0;
  double spread = 0;

  struct Memory {};
  [[nodiscard]] double depth(const Vec3& point) const { return radius - (point - centre).norm(); }
  [[nodiscard]] static double floor_mm() { return 0.5; }
  [[nodiscard]] bool is_apart(const PointTree::Node& node) const { return spread > 0.5 * node.radius; }
  [[nodiscard]] bool is_coarse(const PointTree::Node& node) const { return node.child == 0 || is_apart(node); }
  [[nodiscard]] DepthRange range_mm(const PointTree::Node& node, double, Memory&) const {
    const double here = depth(node.centre), slack = node.radius + spread;
    if (parts > 0 || !((node.centre - centre).norm() > 0))
      return {here - slack, here + slack, here + slack, Vec3::Zero()};
    const Vec3 slope = (centre - node.centre).normalized();
    return {here - slack, here + PointTree::reach_mm(node, slope), here, slope};
  }
  [[nodiscard]] double depth_mm(const FieldPoint& point, double, Memory&) const {
    return depth(point.at) > floor_mm() ? depth(point.at) : 0;
  }
};

/// For each point whether the depth found is the deepest of the first `count` balls. Returns how many are in one.
std::size_t expect_deepest(const std::vector<FieldPoint>& points, const std::vector<float>& found,
                           const std::vector<Ball>& balls, std::size_t count) {
  std::size_t deep = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double truth = 0;
    for (std::size_t b = 0; b < count; ++b) truth = std::max(truth, balls[b].depth(points[i].at));
    if (!(truth > Ball::floor_mm())) truth = 0;
    const auto depth = static_cast<double>(found[i]);
    EXPECT_LE(depth, truth + 1e-5);
    EXPECT_GE(depth * PointDepths::kUnseen + 1e-5, truth);
    deep += depth > 0 ? 1U : 0U;
  }
  return deep;
}

std::vector<FieldPoint> wavy_field() {
  std::vector<FieldPoint> points;
  for (const Vec3& point : wavy_points(3000)) points.push_back({point});
  return points;
}

TEST(PointDepths, AreTheLargestOfAllBodies) {
  const std::vector<Ball> balls = {{{3, 2, 0}, 6}, {{-10, 8, 1}, 3}, {{5, 2, 0}, 7}, {{300, 2, 0}, 7}};
  const std::vector<FieldPoint> points = wavy_field();
  const std::size_t deep = expect_deepest(points, PointDepths(points).deepest(balls), balls, balls.size());
  EXPECT_GT(deep, 100U);
  EXPECT_LT(deep, points.size());
}

/// Forty balls, and behind them those that represent four of them.
std::vector<Ball> grouped_balls() {
  std::vector<Ball> balls;
  for (int k = 0; k < 40; ++k) balls.push_back({Vec3(0.4 * k - 8, 0.2 * k, 1), 5 + 0.05 * (k % 7)});
  const std::size_t count = balls.size();
  for (std::uint32_t first = 0; first < count; first += 4) {
    Ball together = balls[first + 2];
    together.first_part = first;
    together.parts = 4;
    for (std::uint32_t k = first; k < first + 4; ++k)
      together.spread = std::max(
          together.spread, (balls[k].centre - together.centre).norm() + std::abs(balls[k].radius - together.radius));
    balls.push_back(together);
  }
  return balls;
}

TEST(PointDepths, AreTheSameWhereBodiesAreAskedTogether) {
  const std::vector<Ball> balls = grouped_balls();
  const std::size_t count = 40;
  const std::vector<FieldPoint> points = wavy_field();
  const std::vector<float> found = PointDepths(points).deepest(balls, balls.size() - count);
  const std::size_t deep = expect_deepest(points, found, balls, count);
  EXPECT_GT(deep, 100U);
  EXPECT_LT(deep, points.size());
}

TEST(AnyDepth, MissesNoBallThatReachesIntoABody) {
  const std::vector<Ball> balls = grouped_balls();
  const std::size_t count = 40;
  const std::vector<FieldPoint> points = wavy_field();
  for (const double radius : {0.0, 0.3, 2.0, 9.0}) {
    const std::vector<float> found = PointDepths(points).deepest(any_depths(balls, radius), balls.size() - count);
    std::size_t kept = 0, reaching = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      double deepest = -1e9;  // of any point of the ball about this one in any of the forty
      for (std::size_t b = 0; b < count; ++b)
        deepest = std::max(deepest, std::min(balls[b].radius, balls[b].depth(points[i].at) + radius));
      if (deepest > Ball::floor_mm()) {
        ++reaching;
        EXPECT_GT(found[i], 0) << "point " << i << ", radius " << radius;
      }
      // A body that represents four is a little larger than they are, and a ball's box than the ball.
      if (deepest < Ball::floor_mm() - 3 - radius) {
        EXPECT_LE(found[i], 0) << "point " << i << ", radius " << radius;
      }
      kept += found[i] > 0 ? 1U : 0U;
    }
    EXPECT_GT(reaching, 100U);
    if (radius < 5) {
      EXPECT_LT(kept, points.size());
    }
  }
}

}  // namespace
}  // namespace gouge::point_tree_test
