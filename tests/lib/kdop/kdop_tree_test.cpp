#include <gtest/gtest.h>

#include "lib/kdop/kdop_tree.h"
#include "tests/support/scatter.h"
#include "tests/support/verify_kdop_tree.h"

namespace gouge::kdop_tree_test {
namespace {

std::vector<Vec3> points_of(std::size_t count) {
  test::Scatter random(4);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(random.point(50) + Vec3(50, 50, 50));
    if (i % 7 == 0) points.back().z() = 5;
  }
  return points;
}

KdopTree tree_of(const std::vector<Vec3>& points, std::size_t width, std::size_t leaf) {
  const DirectionSet set = cube_directions(18);
  return build_kdop_tree(set, points, {width, leaf}, [&](std::uint32_t i, float* intervals) {
    write_intervals(set, std::span(points).subspan(i, 1), 1e-4, intervals);
  });
}

TEST(KdopTree, HoldsEveryItemOnceAndEveryChildInItsParent) {
  for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 500U}) {
    for (const std::size_t width : {2U, 4U, 8U}) {
      for (const std::size_t leaf : {1U, 3U, 20U}) {
        const std::vector<Vec3> points = points_of(count);
        const KdopTree tree = tree_of(points, width, leaf);
        EXPECT_EQ(test::verify_kdop_tree(tree), std::vector<std::string>{}) << count << " " << width << " " << leaf;
        for (const KdopNode& node : tree.nodes) {
          EXPECT_LE(node.children, width);
          if (node.children == 0) {
            EXPECT_LE(node.item_count, leaf);
          }
        }
      }
    }
  }
}

TEST(KdopTree, OfNothingIsEmpty) { EXPECT_TRUE(tree_of({}, 2, 1).nodes.empty()); }

TEST(KdopTree, BroaderTreesAreShallower) {
  const std::vector<Vec3> points = points_of(4096);
  const auto levels = [&](std::size_t width) {
    std::uint16_t deepest = 0;
    for (const KdopNode& node : tree_of(points, width, 1).nodes) deepest = std::max(deepest, node.level);
    return deepest;
  };
  EXPECT_EQ(levels(2), 12);
  EXPECT_EQ(levels(4), 6);
  EXPECT_EQ(levels(8), 4);
}

TEST(KdopTree, VerificationSeesABrokenTree) {
  const std::vector<Vec3> points = points_of(50);
  KdopTree tree = tree_of(points, 2, 4);
  tree.bounds_of(0)[high_slot(1)] = 0;
  EXPECT_FALSE(test::verify_kdop_tree(tree).empty());
  tree = tree_of(points, 2, 4);
  tree.order[0] = tree.order[1];
  EXPECT_FALSE(test::verify_kdop_tree(tree).empty());
}

TEST(Intervals, OverlapOnlyWhenTheyMeetAlongEveryAxis) {
  const DirectionSet set = cube_directions(26);
  std::vector<float> a(2 * interval_stride(13)), b(a);
  // Two thin diagonal rods side by side: their boxes meet, their volumes do not.
  write_intervals(set, std::vector<Vec3>{Vec3(0, 0, 0), Vec3(10, 10, 0)}, 0, a.data());
  write_intervals(set, std::vector<Vec3>{Vec3(2, 0, 0), Vec3(12, 10, 0)}, 0, b.data());
  EXPECT_FALSE(do_overlap(a.data(), b.data(), interval_stride(13)));
  write_intervals(set, std::vector<Vec3>{Vec3(0, 0, 0), Vec3(12, 10, 0)}, 0, b.data());
  EXPECT_TRUE(do_overlap(a.data(), b.data(), interval_stride(13)));
}

}  // namespace
}  // namespace gouge::kdop_tree_test
