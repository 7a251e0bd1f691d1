#include "lib/head/plane_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "lib/hierarchy/block_tree.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::plane_bound_test {
namespace {

using test::Scatter;

double depth_at(const HeadBody& head, const Vec3& x) {
  return std::max(0.0, -head.surface.closest_point(x)->signed_mm());
}

// A point of the convex hull of some.
template <std::size_t N>
Vec3 within(const std::array<Vec3, N>& corners, Scatter& random) {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (const Vec3& corner : corners) {
    const double weight = random.in(0, 1) * random.in(0, 1);
    sum += weight * corner;
    weights += weight;
  }
  return sum / weights;
}

struct Tally {
  int bounded = 0, deep = 0, raised = 0;
};

// Pieces about the surface, of all sizes: no point of any is deeper than its bound.
Tally try_pieces(const IndexedMesh& mesh, std::uint64_t seed) {
  Scatter random(seed);
  const HeadBody head = *build_head_body(mesh);
  const double size = head.box.diagonal().norm();
  Tally tally;
  for (int i = 0; i < 400; ++i) {
    const double spread = size * std::pow(10.0, random.in(-3, -0.5));
    const Vec3 about = mesh.corner(random.below(mesh.triangles.size()), 0) + spread * random.point(1);
    std::array<Vec3, 6> corners;
    for (Vec3& corner : corners) corner = about + spread * random.point(1);
    const PieceRegion region(corners, 0.01 * spread);
    const ClosestPoint foot = *head.surface.closest_point(region.middle);
    const double cutoff_mm = random.in(0, 0.3) * spread;
    // Any plane will do: also that of another point.
    const HeadPlane plane(random.is(0.5) ? foot : *head.surface.closest_point(corners[random.below(6)]));
    const auto bound_mm = depth_by_plane(head, region, plane, foot.is_inside, cutoff_mm);
    if (!bound_mm) continue;
    ++tally.bounded;
    tally.raised += *bound_mm >= cutoff_mm ? 1 : 0;
    double deepest_mm = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec3 x = k < 6 ? corners[static_cast<std::size_t>(k)] : within(corners, random);
      deepest_mm = std::max(deepest_mm, depth_at(head, x + 0.01 * spread * random.point(1).normalized()));
    }
    EXPECT_LE(deepest_mm, *bound_mm + 1e-9) << mesh.name << " " << i;
    tally.deep += deepest_mm > 1e-6 ? 1 : 0;
  }
  return tally;
}

TEST(PlaneBound, IsNowhereExceeded) {
  std::uint64_t seed = 1;
  for (const IndexedMesh& mesh :
       {shapes::cube(), shapes::sphere(), shapes::torus(), shapes::bumpy_sphere(), shapes::needle_fan()}) {
    const Tally tally = try_pieces(mesh, seed++);
    EXPECT_GT(tally.bounded, 40) << mesh.name;
    EXPECT_GT(tally.deep, 10) << mesh.name;
  }
}

TEST(PlaneBound, OfANodeIsNowhereExceeded) {
  Scatter random(5);
  const HeadBody head = *build_head_body(shapes::torus());
  const IndexedMesh part = shapes::bumpy_sphere();
  const BlockTree tree = build_block_tree({&part, 1});
  const double size = head.box.diagonal().norm();
  int bounded = 0;
  for (int i = 0; i < 300; ++i) {
    const NodeBlock& node = tree.nodes[random.below(tree.nodes.size())];
    const LaneBound held(tree, node, random.below(node.count));
    RigidTransform to_tool0, to_tool1;
    to_tool0.rotation = Eigen::AngleAxisd(random.in(0, 3), random.point(1).normalized()).toRotationMatrix();
    to_tool1.rotation = to_tool0.rotation;
    const Vec3 to = head.surface.mesh().corner(random.below(head.surface.mesh().triangles.size()), 0);
    to_tool0.shift = to - to_tool0.rotation * held.center + 0.05 * size * random.point(1);
    to_tool1.shift = to_tool0.shift + 0.05 * size * random.point(1);
    const NodeRegion region(held, to_tool0, to_tool1, 0);
    const ClosestPoint foot = *head.surface.closest_point(region.middle);
    const auto bound_mm = depth_by_plane(head, region, HeadPlane(foot), foot.is_inside, 0.05 * size);
    if (!bound_mm) continue;
    ++bounded;
    const std::array<Vec3, 8> hull = held.hull();
    for (int k = 0; k < 100; ++k) {
      // The region of the node's bound: its ball and disc. Any point between both ends.
      const Vec3 x = within(hull, random);
      if ((x - held.center).norm() > held.radius_mm) continue;
      const Vec3 q0 = to_tool0.point(x), q1 = to_tool1.point(x);
      if ((x - held.center - held.normal * held.normal.dot(x - held.center)).norm() > held.disc_radius_mm) continue;
      EXPECT_LE(depth_at(head, q0 + random.in(0, 1) * (q1 - q0)), *bound_mm + 1e-9) << i;
    }
  }
  EXPECT_GT(bounded, 50);
}

TEST(PlaneBound, IsExactUnderAFace) {
  const HeadBody head = *build_head_body(shapes::cube());
  const Box3 box = head.box;
  const Vec3 top(box.center().x(), box.center().y(), box.max().z());
  const double step = 0.05 * box.sizes().x();
  const auto piece_at = [&](double height) {
    const Vec3 at = top + height * Vec3::UnitZ();
    return std::array<Vec3, 6>{at,
                               at + step * Vec3::UnitX(),
                               at + step * Vec3::UnitY(),
                               at + step * Vec3(1, 1, 0),
                               at - step * Vec3::UnitX(),
                               at - step * Vec3::UnitY()};
  };
  for (const double depth : {0.0, 0.01, 0.1}) {
    const PieceRegion region(piece_at(-depth * step), 0);
    const ClosestPoint foot = *head.surface.closest_point(region.middle);
    const auto bound_mm = depth_by_plane(head, region, HeadPlane(foot), foot.is_inside, 0);
    ASSERT_TRUE(bound_mm.has_value());
    EXPECT_NEAR(*bound_mm, depth * step, 2e-6);
  }
  const PieceRegion above(piece_at(1e-4), 0);
  const ClosestPoint over = *head.surface.closest_point(above.middle);
  EXPECT_EQ(depth_by_plane(head, above, HeadPlane(over), over.is_inside, 0), 0.0);
}

}  // namespace
}  // namespace gouge::plane_bound_test
