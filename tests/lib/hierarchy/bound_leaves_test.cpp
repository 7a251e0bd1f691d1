#include "lib/hierarchy/bound_leaves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/scatter.h"

namespace gouge::detail::bound_leaves_test {
namespace {

/// Leaves about a plane, the last one with `last_count` triangles.
std::vector<TriangleBlock> random_leaves(std::size_t count, std::uint32_t last_count, double size, unsigned seed) {
  test::Scatter random(seed);
  std::vector<TriangleBlock> leaves(count);
  for (std::size_t l = 0; l < count; ++l) {
    leaves[l].count = l + 1 == count ? last_count : kBlockLanes;
    for (std::size_t i = 0; i < kBlockLanes; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 corner = random.point(size).cwiseProduct(Vec3(1, 1, 0.01));
        for (std::size_t k = 0; k < 3; ++k) {
          leaves[l].corner[c][k][i] = i < leaves[l].count ? static_cast<float>(corner[static_cast<Eigen::Index>(k)])
                                                          : leaves[l].corner[c][k][0];
        }
      }
    }
  }
  return leaves;
}

/// How far the corner that sticks out most is outside of a lane's bounds; each of the three alone.
struct Outside {
  double height = -1e9, disc = -1e9, radius = -1e9;
};

Outside outside(const std::vector<TriangleBlock>& leaves, const NodeBlock& node, std::size_t lane) {
  const auto vector = [lane](const std::array<Lanes, 3>& from) {
    return Vec3(from[0][lane], from[1][lane], from[2][lane]);
  };
  const Vec3 normal = vector(node.normal);
  Outside out;
  for (const TriangleBlock& leaf : leaves) {
    for (const auto& c : leaf.corner) {
      for (std::size_t i = 0; i < leaf.count; ++i) {
        const Vec3 d = Vec3(c[0][i], c[1][i], c[2][i]) - vector(node.center);
        const double h = normal.dot(d);
        out.height = std::max(out.height, std::abs(h) - static_cast<double>(node.half_thickness_mm[lane]));
        out.disc = std::max(out.disc, (d - h * normal).norm() - static_cast<double>(node.disc_radius_mm[lane]));
        out.radius = std::max(out.radius, d.norm() - static_cast<double>(node.radius_mm[lane]));
      }
    }
  }
  return out;
}

TEST(BoundLeaves, EveryCornerIsWithinAndTheFarthestHardlyIs) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const double size = std::pow(10.0, static_cast<double>(seed % 9) - 4);
    const std::uint32_t last_count = 1 + seed % 16;
    const auto leaves = random_leaves(1 + seed % 5, last_count, size, seed);
    NodeBlock node;
    const Vec3 lean(0.1, 0.02 * seed, seed % 2 == 0 ? 3 : -3);
    bound_leaves(leaves, seed == 7 ? Vec3::Zero() : lean, 1e-6, node, 3);
    const Outside out = outside(leaves, node, 3);
    for (const double beyond : {out.height, out.disc, out.radius}) {
      EXPECT_LE(beyond, -1e-6) << seed;
      EXPECT_GE(beyond, -(1e-6 + 2e-9 + 2e-6 * size)) << seed;
    }
  }
}

TEST(BoundLeaves, TheSumOfAreasLeavesOutLanesThatAreNotInUse) {
  auto leaves = random_leaves(1, 5, 10, 9);
  const std::array<float, 3> five = area_sum(leaves[0]);
  leaves[0].count = 1;
  const std::array<float, 3> one = area_sum(leaves[0]);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto at = [&](std::size_t c) {
      return Vec3(leaves[0].corner[c][0][i], leaves[0].corner[c][1][i], leaves[0].corner[c][2][i]);
    };
    sum += (at(1) - at(0)).cross(at(2) - at(0));
    if (i == 0) {
      for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(one[static_cast<std::size_t>(k)], sum[k], 1e-3);
    }
  }
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(five[static_cast<std::size_t>(k)], sum[k], 1e-3);
}

}  // namespace
}  // namespace gouge::detail::bound_leaves_test
