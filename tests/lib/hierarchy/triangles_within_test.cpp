#include "lib/hierarchy/triangles_within.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::triangles_within_test {
namespace {

using test::Scatter;

using Space = std::vector<HalfSpace>;

bool is_in(const Vec3& x, const Space& space) {
  return std::ranges::all_of(space, [&](const HalfSpace& half) { return half.direction.dot(x) >= half.min_mm; });
}

// How surely a triangle reaches into a space: by its corners and points in between.
bool has_point_in(const BlockTree& tree, std::uint32_t triangle, const Space& space) {
  const auto [a, b, c] = tree.corners(triangle);
  for (int i = 0; i <= 6; ++i) {
    for (int k = 0; i + k <= 6; ++k) {
      if (is_in(a + i / 6.0 * (b - a) + k / 6.0 * (c - a), space)) return true;
    }
  }
  return false;
}

// Between two planes near a corner of the triangle, and perhaps beyond some others.
Space space_about(const Vec3& x, Scatter& random) {
  Space space;
  const Vec3 n = (random.point(1) + Vec3(1e-3, 0, 0)).normalized();
  space.push_back({n, n.dot(x) - 0.3});
  space.push_back({-n, -n.dot(x) - 1e-6});
  for (std::size_t more = random.below(5); more > 0; --more) {
    const Vec3 d = (random.point(1) + Vec3(1e-3, 0, 0)).normalized();
    space.push_back({d, d.dot(x) - random.in(0, 5)});
  }
  return space;
}

TEST(TrianglesWithin, MissesNoneAndLeavesMostOut) {
  Scatter random(11);
  std::array<IndexedMesh, 2> meshes{shapes::sphere(), shapes::torus()};
  for (Vec3& v : meshes[1].vertices) v += Vec3(100, 20, -4);
  const BlockTree tree = build_block_tree(meshes);
  const auto all = static_cast<std::uint32_t>(meshes[0].triangles.size() + meshes[1].triangles.size());
  std::size_t found_in_all = 0;
  for (int i = 0; i < 200; ++i) {
    const auto about = static_cast<std::uint32_t>(random.below(all));
    const Space space = space_about(tree.corners(about)[0], random);
    const std::vector<std::uint32_t> found = triangles_within(tree, space);
    EXPECT_TRUE(std::ranges::is_sorted(found));
    EXPECT_TRUE(std::ranges::binary_search(found, about));
    EXPECT_TRUE(is_entered(tree, space));
    for (std::uint32_t t = 0; t < all; ++t)
      EXPECT_TRUE(std::ranges::binary_search(found, t) || !has_point_in(tree, t, space)) << t;
    found_in_all += found.size();
  }
  EXPECT_LT(found_in_all, 200U * all / 4);
}

TEST(TrianglesWithin, ASpaceIsEnteredAsTheTrianglesAre) {
  Scatter random(12);
  const IndexedMesh mesh = shapes::torus();
  const BlockTree tree = build_block_tree({&mesh, 1});
  int entered = 0, free = 0;
  for (int i = 0; i < 2000; ++i) {
    // Boxes off the surface by about their size.
    const Vec3 x = mesh.corner(random.below(mesh.triangles.size()), 0) + 2 * random.point(1);
    Space space;
    for (int axis = 0; axis < 3; ++axis) {
      const double half = random.in(0, 1);
      space.push_back({Vec3::Unit(axis), x[axis] - half});
      space.push_back({-Vec3::Unit(axis), -x[axis] - half});
    }
    bool has_point = false;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) has_point = has_point || has_point_in(tree, t, space);
    const bool is = is_entered(tree, space);
    EXPECT_TRUE(is || !has_point) << i;
    entered += is ? 1 : 0;
    free += is ? 0 : 1;
  }
  EXPECT_GT(entered, 200);
  EXPECT_GT(free, 200);
}

TEST(TrianglesWithin, IsNotEnteredFarFromTheTriangleButInItsPlane) {
  IndexedMesh mesh = shapes::cube();
  const BlockTree tree = build_block_tree({&mesh, 1});
  const auto box = [](const Vec3& low, const Vec3& high) {
    Space space;
    for (int axis = 0; axis < 3; ++axis) {
      space.push_back({Vec3::Unit(axis), low[axis]});
      space.push_back({-Vec3::Unit(axis), -high[axis]});
    }
    return space;
  };
  EXPECT_TRUE(is_entered(tree, box({4, 4, 9}, {5, 5, 11})));
  EXPECT_FALSE(is_entered(tree, box({10.1, 4, 9}, {12, 5, 11})));
  EXPECT_FALSE(is_entered(tree, box({4, 4, 4}, {5, 5, 5})));
  EXPECT_FALSE(is_entered(tree, box({4, 4, 10 + 1e-8}, {5, 5, 11})));
}

TEST(TrianglesWithin, HighestAlongADirectionIsThatOfTheCorners) {
  Scatter random(14);
  std::array<IndexedMesh, 2> meshes{shapes::sphere(), shapes::torus()};
  for (Vec3& v : meshes[1].vertices) v += Vec3(100, 20, -4);
  const BlockTree tree = build_block_tree(meshes);
  int above = 0, beyond = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 n = random.direction();
    double highest = -1e300;
    for (const IndexedMesh& mesh : meshes) {
      for (const Vec3& v : mesh.vertices) highest = std::max(highest, n.dot(v));
    }
    const double low = highest + random.in(-3, 1), high = low + random.in(0, 4);
    const double found = highest_along(tree, n, low, high);
    EXPECT_EQ(std::isinf(found), highest > high) << i;
    if (highest <= high) {
      EXPECT_NEAR(found, std::max(low, highest), 1e-9) << i;
    }
    above += highest > low && highest <= high ? 1 : 0;
    beyond += highest > high ? 1 : 0;
  }
  EXPECT_GT(above, 100);
  EXPECT_GT(beyond, 50);
}

TEST(TrianglesWithin, OfNoTrianglesAreNone) {
  EXPECT_TRUE(triangles_within(BlockTree{}, {}).empty());
  EXPECT_FALSE(is_entered(BlockTree{}, {}));
  EXPECT_EQ(highest_along(BlockTree{}, Vec3::UnitZ(), 2, 3), 2);
}

TEST(TrianglesWithin, MissesNoneFarAwayInATreeOfVeryDifferentSizes) {
  Scatter random(13);
  std::array<IndexedMesh, 2> meshes{shapes::sphere(), shapes::torus()};
  for (Vec3& v : meshes[0].vertices) v = 1e-3 * v + Vec3(90'000, -50'000, 30'000);
  for (Vec3& v : meshes[1].vertices) v += Vec3(91'000, -50'000, 30'000);
  const BlockTree tree = build_block_tree(meshes);
  const auto all = static_cast<std::uint32_t>(meshes[0].triangles.size());
  for (int i = 0; i < 500; ++i) {
    const auto about = static_cast<std::uint32_t>(random.below(all));
    const Vec3 x = tree.corners(about)[0];
    Space space;
    for (int k = 0; k < 4; ++k) {
      const Vec3 d = random.direction();
      space.push_back({d, d.dot(x)});
    }
    EXPECT_TRUE(std::ranges::binary_search(triangles_within(tree, space), about));
    EXPECT_TRUE(is_entered(tree, space));
  }
}

}  // namespace
}  // namespace gouge::triangles_within_test
