#include "lib/field/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "lib/field/point_depths.h"

namespace gouge {
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

TEST(PointTree, HoldsEveryPointOnceInLeavesOfTheirBoxes) {
  for (const std::size_t count : {0U, 1U, 16U, 17U, 1000U, 5000U}) {
    const std::vector<Vec3> points = wavy_points(count);
    const PointTree tree(points);
    std::vector<std::size_t> order = tree.order();
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(order[i], i);
    std::size_t in_leaves = 0;
    for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
      const PointTree::Node& node = tree.nodes()[n];
      for (std::size_t i = node.first; i < node.last; ++i) {
        const Vec3& point = points[tree.order()[i]];
        EXPECT_TRUE(node.box.contains(point));
        EXPECT_LE((point - node.centre).norm(), node.radius * (1 + 1e-12));
      }
      if (node.child == 0) {
        EXPECT_LE(node.last - node.first, PointTree::kLeafPoints);
        in_leaves += node.last - node.first;
      } else {
        ASSERT_GT(node.child, n);
        EXPECT_EQ(tree.nodes()[node.child].first, node.first);
        EXPECT_EQ(tree.nodes()[node.child].last, tree.nodes()[node.child + 1].first);
        EXPECT_EQ(tree.nodes()[node.child + 1].last, node.last);
      }
    }
    EXPECT_EQ(in_leaves, count);
  }
}

TEST(PointTree, IsCutIntoBlocksThatShareNoPoint) {
  const PointTree tree(wavy_points(5000));
  EXPECT_GT(tree.blocks().size(), 30U);
  std::size_t next = 0;
  for (const std::size_t block : tree.blocks()) {
    EXPECT_EQ(tree.nodes()[block].first, next);
    next = tree.nodes()[block].last;
  }
  EXPECT_EQ(next, 5000U);
}

/// A ball whose inside is as deep as it is far from its surface.
struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0;

  [[nodiscard]] double depth_mm(const Vec3& point) const { return radius - (point - centre).norm(); }
  [[nodiscard]] static double floor_mm() { return 0.5; }
  [[nodiscard]] double most_mm(const PointTree::Node& node, double) const {
    return depth_mm(node.centre) + node.radius;
  }
  [[nodiscard]] PointDepths::LeafDepths depths(std::span<const FieldPoint> points, std::span<const float>) const {
    PointDepths::LeafDepths found{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double depth = depth_mm(points[i].at);
      if (depth > floor_mm()) found[i] = static_cast<float>(depth);
    }
    return found;
  }
};

TEST(PointDepths, AreTheLargestOfAllBodies) {
  const std::vector<Ball> balls = {{{3, 2, 0}, 6}, {{-10, 8, 1}, 3}, {{5, 2, 0}, 7}, {{300, 2, 0}, 7}};
  std::vector<FieldPoint> points;
  for (const Vec3& point : wavy_points(3000)) points.push_back({point, false});
  const std::vector<float> deepest = PointDepths(points).deepest(balls);
  std::size_t deep = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double truth = 0;
    for (const Ball& ball : balls) truth = std::max(truth, ball.depth_mm(points[i].at));
    if (!(truth > Ball::floor_mm())) truth = 0;
    const auto found = static_cast<double>(deepest[i]);
    EXPECT_LE(found, truth + 1e-5);
    EXPECT_GE(found * PointDepths::kUnseen + 1e-5, truth);
    deep += found > 0 ? 1U : 0U;
  }
  EXPECT_GT(deep, 100U);
  EXPECT_LT(deep, points.size());
}

}  // namespace
}  // namespace gouge
