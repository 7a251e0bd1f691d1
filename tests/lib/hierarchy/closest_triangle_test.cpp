#include "lib/hierarchy/closest_triangle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "lib/hierarchy/distance_kernel.h"
#include "lib/hierarchy/lane_bound.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::closest_triangle_test {
namespace {

IndexedMesh moved(IndexedMesh mesh, double scale, const Vec3& by) {
  for (Vec3& v : mesh.vertices) v = scale * v + by;
  return mesh;
}

/// Every triangle `copies` times, one after another.
IndexedMesh repeated(IndexedMesh mesh, std::size_t copies) {
  const auto once = mesh.triangles;
  for (std::size_t k = 1; k < copies; ++k) {
    for (const TriangleCorners& t : once) shapes::add_triangle(mesh, t[0], t[1], t[2]);
  }
  return mesh;
}

/// Triangles of all proportions: long needles, slivers without height, points.
IndexedMesh needles(std::size_t count, unsigned seed) {
  test::Scatter random(seed);
  IndexedMesh mesh;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 a = random.point(50), along = random.point(std::pow(10.0, random.in(-3, 2)));
    const double width = std::pow(10.0, random.in(-9, 0));
    mesh.vertices.push_back(a);
    mesh.vertices.push_back(t % 17 == 0 ? a : Vec3(a + along));
    mesh.vertices.push_back(a + random.in(-0.5, 1.5) * along + width * random.direction());
    shapes::add_triangle(mesh, 3 * t, 3 * t + 1, 3 * t + 2);
  }
  return mesh;
}

std::vector<IndexedMesh> meshes() {
  return {shapes::cube(),
          shapes::sphere(),
          shapes::torus(),
          shapes::needle_fan(),
          shapes::bumpy_sphere(),
          repeated(shapes::torus(40, 12, 24, 12), 3),
          needles(3000, 1),
          moved(shapes::torus(), 1, Vec3(1e5, -1e5, 7e4)),
          moved(needles(600, 2), 1e-2, Vec3(-1e5, 2, 9e4)),
          moved(shapes::sphere(), 1e-4, Vec3(0, 0, 1e5))};
}

/// On the surface, at its vertices, next to it, around it and far away.
Vec3 random_point(const IndexedMesh& mesh, test::Scatter& random) {
  const std::size_t t = random.next() % mesh.triangles.size();
  const double u = random.in(0, 1), v = random.in(0, 1 - u), size = mesh.box().diagonal().norm();
  const Vec3 &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
  const Vec3 at = a + u * (b - a) + v * (c - a);
  switch (random.next() % 6) {
    case 0:
      return at;
    case 1:
      return a;
    case 2:
      return 0.5 * (a + b);
    case 3:
      return at + std::pow(10.0, random.in(-9, 0)) * size * random.direction();
    case 4:
      return mesh.box().center() + random.point(size);
    default:
      return mesh.box().center() + std::pow(10.0, random.in(0, 4)) * size * random.direction();
  }
}

ClosestTriangle by_brute_force(const IndexedMesh& mesh, const Vec3& point) {
  ClosestTriangle best;
  best.foot.distance2_mm2 = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TrianglePoint foot = closest_on_triangle(point, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    if (foot.distance2_mm2 < best.foot.distance2_mm2) best = {t, foot};
  }
  return best;
}

TEST(ClosestTriangle, IsThatOfAllTrianglesToTheLastBitTheLowestOfTies) {
  test::Scatter random(3);
  test::Scatter from(19);
  for (const IndexedMesh& mesh : meshes()) {
    const BlockTree tree = build_block_tree({&mesh, 1});
    for (int i = 0; i < 1000; ++i) {
      const Vec3 point = random_point(mesh, random);
      const auto found = closest_triangle(tree, point);
      const ClosestTriangle truth = by_brute_force(mesh, point);
      ASSERT_TRUE(found);
      // From any triangle, near or far; also where the nearest known so far is nearer than what single precision
      // makes of it.
      const auto near = static_cast<std::uint32_t>(from.below(mesh.triangles.size()));
      for (const std::uint32_t begin : {near, truth.triangle}) {
        const ClosestTriangle again = closest_triangle_from(tree, point, begin);
        EXPECT_EQ(again.triangle, truth.triangle) << mesh.name << " " << point.transpose() << " from " << begin;
        EXPECT_EQ(std::memcmp(again.foot.point.data(), truth.foot.point.data(), sizeof(Vec3)), 0);
      }
      EXPECT_EQ(found->triangle, truth.triangle) << mesh.name << " " << point.transpose();
      EXPECT_EQ(std::memcmp(found->foot.point.data(), truth.foot.point.data(), sizeof(Vec3)), 0);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(found->foot.distance2_mm2),
                std::bit_cast<std::uint64_t>(truth.foot.distance2_mm2));
    }
  }
}

TEST(ClosestTriangle, OfATreeOverSeveralMeshesIsThatOfAll) {
  const std::vector<IndexedMesh> two{shapes::torus(), moved(shapes::sphere(), 1, Vec3(30, 5, 0))};
  const BlockTree tree = build_block_tree(two);
  test::Scatter random(4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 point = random_point(two[static_cast<std::size_t>(i % 2)], random);
    const ClosestTriangle a = by_brute_force(two[0], point), b = by_brute_force(two[1], point);
    const bool is_first = a.foot.distance2_mm2 <= b.foot.distance2_mm2;
    const auto first = static_cast<std::uint32_t>(two[0].triangles.size());
    EXPECT_EQ(closest_triangle(tree, point)->triangle, is_first ? a.triangle : first + b.triangle);
  }
}

TEST(ClosestTriangle, StaysWithinTheDistanceAskedFor) {
  const IndexedMesh mesh = shapes::cube(10);
  const BlockTree tree = build_block_tree({&mesh, 1});
  EXPECT_TRUE(closest_triangle(tree, Vec3(5, 5, 12), 2));
  EXPECT_FALSE(closest_triangle(tree, Vec3(5, 5, 12), 1.999999));
  EXPECT_TRUE(closest_triangle(tree, Vec3(5, 5, 10), 0));
  EXPECT_FALSE(closest_triangle(BlockTree{}, Vec3(5, 5, 10)));
}

struct Outcome {
  Lanes least{};
  std::uint32_t near = 0;
  float within = 0;
};

DistanceQuery query_at(const BlockTree& tree, const Vec3& point) {
  const Vec3 local = point - tree.origin;
  const double rounding_mm = DistanceQuery::kTriangleRounding * (local.norm() + tree.radius_mm);
  return {{static_cast<float>(local.x()), static_cast<float>(local.y()), static_cast<float>(local.z())},
          0,
          static_cast<float>(rounding_mm)};
}

TEST(DistanceKernel, GivesTheSameBytesWithEveryInstructionSet) {
  test::Scatter random(5);
  for (const IndexedMesh& mesh : meshes()) {
    const BlockTree tree = build_block_tree({&mesh, 1});
    for (int i = 0; i < 200; ++i) {
      const DistanceQuery query = query_at(tree, random_point(mesh, random));
      const NodeBlock& node = tree.nodes[random.next() % tree.nodes.size()];
      const TriangleBlock& leaf = tree.leaves[random.next() % tree.leaves.size()];
      const auto within = static_cast<float>(random.in(0, 20));
      const auto outcome = [&](const DistanceKernel& kernel, bool is_of_nodes) {
        Outcome all;
        all.within = within;
        all.near = is_of_nodes ? kernel.nodes(node, query, all.within, all.least)
                               : kernel.triangles(leaf, query, all.within, all.least);
        return all;
      };
      for (const bool is_of_nodes : {true, false}) {
        const Outcome plain = outcome(*distance_kernels()[0], is_of_nodes);
        for (const DistanceKernel* const kernel : distance_kernels()) {
          const Outcome other = outcome(*kernel, is_of_nodes);
          EXPECT_EQ(std::memcmp(&other, &plain, sizeof plain), 0) << kernel->name;
        }
      }
    }
  }
}

double min_below(const BlockTree& tree, const NodeBlock& node, std::size_t lane, const Vec3& point) {
  double least2 = std::numeric_limits<double>::infinity();
  if (node.has_leaves) {
    const TriangleBlock& leaf = tree.leaves[node.child[lane]];
    for (std::size_t i = 0; i < leaf.count; ++i)
      least2 = std::min(least2, closest_on_triangle(point, tree.corners(leaf.triangle[i])).distance2_mm2);
    return std::sqrt(least2);
  }
  double least = least2;
  const NodeBlock& child = tree.nodes[node.child[lane]];
  for (std::size_t k = 0; k < child.count; ++k) least = std::min(least, min_below(tree, child, k, point));
  return least;
}

// Without the slack of the query, at points that single precision holds.
TEST(DistanceKernel, IsNeverAboveTheDistanceAndOftenNearIt) {
  test::Scatter random(6);
  std::size_t tight = 0, all = 0;
  for (const IndexedMesh& mesh : meshes()) {
    const BlockTree tree = build_block_tree({&mesh, 1});
    for (int i = 0; i < 100; ++i) {
      const DistanceQuery query = query_at(tree, random_point(mesh, random));
      const Vec3 rounded = tree.origin + Vec3(static_cast<double>(query.point[0]), static_cast<double>(query.point[1]),
                                              static_cast<double>(query.point[2]));
      const double slack = tree.rounding_mm + 1e-9;
      const NodeBlock& node = tree.nodes[random.next() % tree.nodes.size()];
      Lanes least;
      float within = 1e30F;
      static_cast<void>(fastest_distance_kernel().nodes(node, query, within, least));
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < node.count; ++k) {
        const double truth = min_below(tree, node, k, rounded);
        nearest = std::min(nearest, truth);
        EXPECT_LE(static_cast<double>(least[k]), truth + slack);
      }
      EXPECT_GE(static_cast<double>(within), nearest - slack);
      within = 1e30F;
      nearest = std::numeric_limits<double>::infinity();
      const TriangleBlock& leaf = tree.leaves[random.next() % tree.leaves.size()];
      static_cast<void>(fastest_distance_kernel().triangles(leaf, query, within, least));
      for (std::size_t k = 0; k < leaf.count; ++k) {
        const auto corners = tree.corners(leaf.triangle[k]);
        const double truth = std::sqrt(closest_on_triangle(rounded, corners).distance2_mm2);
        EXPECT_LE(static_cast<double>(least[k]), truth + slack);
        nearest = std::min(nearest, truth);
        ++all;
        if (static_cast<double>(least[k]) >= 0.999 * truth - slack) ++tight;
      }
      EXPECT_GE(static_cast<double>(within), nearest - slack);
    }
  }
  EXPECT_GT(tight, all * 9 / 10);
}

TEST(LaneBound, HoldsEverythingBelow) {
  test::Scatter random(7);
  for (const IndexedMesh& mesh : meshes()) {
    const BlockTree tree = build_block_tree({&mesh, 1});
    for (const NodeBlock& node : tree.nodes) {
      if (!node.has_leaves) continue;
      for (std::size_t lane = 0; lane < node.count; ++lane) {
        const LaneBound bound(tree, node, lane);
        const Vec3 direction = random.direction(), point = random_point(mesh, random);
        const Vec3 up = bound.normal.normalized();
        double height = 0;
        for (const Vec3& corner : bound.hull()) height = std::max(height, up.dot(corner - bound.center));
        const TriangleBlock& leaf = tree.leaves[node.child[lane]];
        for (std::size_t i = 0; i < leaf.count; ++i) {
          const auto corners = tree.corners(leaf.triangle[i]);
          for (const Vec3& x : corners) {
            EXPECT_LE(direction.dot(x - bound.center), bound.extent_mm(direction) + 1e-9);
            EXPECT_LE(std::abs(up.dot(x - bound.center)), height + 1e-9);
          }
          EXPECT_LE(bound.min_distance_mm(point), std::sqrt(closest_on_triangle(point, corners).distance2_mm2) + 1e-9);
        }
      }
    }
  }
}

}  // namespace
}  // namespace gouge::closest_triangle_test
