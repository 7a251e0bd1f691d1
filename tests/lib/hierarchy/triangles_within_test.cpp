#include "lib/hierarchy/triangles_within.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge {
namespace {

// By the corners: a triangle may reach into each of two slabs and not into both, which is no miss.
bool has_corner_in(const BlockTree& tree, std::uint32_t triangle, std::span<const Slab> slabs) {
  const std::array<Vec3, 3> corners = tree.corners(triangle);
  return std::any_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
    return std::all_of(slabs.begin(), slabs.end(), [&](const Slab& slab) {
      const double height = slab.normal.dot(corner);
      return height >= slab.low_mm && height <= slab.high_mm;
    });
  });
}

bool crosses(const BlockTree& tree, std::uint32_t triangle, const Slab& slab) {
  double low = 1e300, high = -1e300;
  for (const Vec3& corner : tree.corners(triangle)) {
    low = std::min(low, slab.normal.dot(corner));
    high = std::max(high, slab.normal.dot(corner));
  }
  return low <= slab.high_mm && high >= slab.low_mm;
}

TEST(TrianglesWithin, MissesNoneAndLeavesMostOut) {
  test::Scatter random(11);
  std::array<IndexedMesh, 2> meshes{shapes::sphere(), shapes::torus()};
  for (Vec3& v : meshes[1].vertices) v += Vec3(100, 20, -4);
  const BlockTree tree = build_block_tree(meshes);
  const std::size_t all = meshes[0].triangles.size() + meshes[1].triangles.size();
  std::size_t found_in_all = 0;
  for (int k = 0; k < 200; ++k) {
    std::array<Slab, 2> slabs;
    const auto about = static_cast<std::uint32_t>(k * 37 % static_cast<int>(all));
    for (Slab& slab : slabs) {
      slab.normal = (random.point(1) + Vec3(1e-3, 0, 0)).normalized();
      slab.low_mm = slab.high_mm = slab.normal.dot(tree.corners(about)[0]);
      slab.low_mm -= 0.3;
    }
    const std::vector<std::uint32_t> both = triangles_within(tree, slabs);
    EXPECT_TRUE(std::ranges::is_sorted(both));
    EXPECT_TRUE(std::ranges::binary_search(both, about));
    const std::vector<std::uint32_t> one = triangles_within(tree, {slabs.data(), 1});
    for (std::uint32_t t = 0; t < all; ++t) {
      EXPECT_TRUE(!has_corner_in(tree, t, slabs) || std::ranges::binary_search(both, t)) << t;
      EXPECT_TRUE(!crosses(tree, t, slabs[0]) || std::ranges::binary_search(one, t)) << t;
    }
    found_in_all += both.size();
  }
  EXPECT_LT(found_in_all, 200 * all / 4);
}

TEST(TrianglesWithin, OfNoTrianglesAreNone) { EXPECT_TRUE(triangles_within(BlockTree{}, {}).empty()); }

}  // namespace
}  // namespace gouge
