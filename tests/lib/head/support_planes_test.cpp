// Planes of facets against all corners, and the depths they bound against the closest point.
#include "lib/head/support_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/head/head_body.h"
#include "lib/head/plane_bound.h"
#include "tests/support/revolved_heads.h"
#include "tests/support/scatter.h"

namespace gouge::support_planes_test {
namespace {

std::vector<IndexedMesh> heads() {
  std::vector<IndexedMesh> all = test::heads_around_the_axis();
  all.push_back(shapes::moved(shapes::tetrahedron(), {100, -30, 7}));
  all.push_back(shapes::slotted_block());
  all.push_back(shapes::needle_fan(60));
  // Corners as a file in single precision gives them: quadrilaterals are no longer flat.
  IndexedMesh rounded = all.front();
  for (Vec3& v : rounded.vertices) v = v.cast<float>().cast<double>();
  all.push_back(rounded);
  return all;
}

TEST(SupportPlanes, RiseNoLessThanAnyCornerAndHardlyMore) {
  std::size_t bounded = 0, all = 0;
  for (const IndexedMesh& mesh : heads()) {
    const Surface surface(mesh);
    const SupportPlanes supports(surface);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t, ++all) {
      const Vec3 n = surface.face_normal(t);
      double rise = 0;
      for (const Vec3& v : mesh.vertices) rise = std::max(rise, n.dot(v - mesh.corner(t, 0)));
      const double told = supports.rise_mm(t);
      ASSERT_GE(told, rise) << mesh.name << ", facet " << t;
      if (std::isfinite(told)) {
        ASSERT_LE(told, rise + 1e-7) << mesh.name << ", facet " << t;
        ++bounded;
      } else {
        ASSERT_GT(rise, 0.99 * SupportPlanes::kMaxRise_mm) << mesh.name << ", facet " << t;
      }
      ASSERT_EQ(told, supports.rise_mm(t));
    }
  }
  EXPECT_GT(bounded, all / 4);
  EXPECT_LT(bounded, all);
}

TEST(SupportPlanes, BoundTheDepthOfPiecesThatMove) {
  std::size_t free = 0, deep = 0;
  for (const IndexedMesh& mesh : heads()) {
    const HeadBody head = *build_head_body(mesh);
    test::Scatter random(5);
    for (int i = 0; i < 400; ++i) {
      const Vec3 about = mesh.vertices[random.below(mesh.vertices.size())] + 3 * random.point(1);
      std::array<Vec3, 6> corners;
      for (Vec3& corner : corners) corner = about + (i % 3 == 0 ? 0.05 : 3) * random.point(1);
      const double bulge = i % 2 == 0 ? 0 : random.in(0, 0.1);
      const auto facet = static_cast<std::uint32_t>(random.below(mesh.triangles.size()));
      const auto plane = head.supports.plane(facet);
      if (!plane) continue;
      const double bound = depth_by_support(PieceRegion(corners, bulge), *plane);
      free += bound <= 0 ? 1 : 0;
      for (int k = 0; k < 60; ++k) {
        double sum = 0;
        Vec3 q = Vec3::Zero();
        for (const Vec3& corner : corners) {
          const double share = k < 6 ? (&corner == &corners[static_cast<std::size_t>(k)] ? 1 : 1e-12) : random.in(0, 1);
          sum += share;
          q += share * corner;
        }
        const double depth = -head.surface.closest_point(q / sum + bulge * random.direction())->signed_mm();
        ASSERT_LE(depth, bound + 1e-9) << mesh.name << ", facet " << facet;
        deep += depth > 0.1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(free, 100u);
  EXPECT_GT(deep, 1000u);
}

TEST(SupportPlanes, TwoBoundDeepPiecesBetterThanEachAlone) {
  std::size_t better = 0, deep = 0;
  for (const IndexedMesh& mesh : heads()) {
    const HeadBody head = *build_head_body(mesh);
    test::Scatter random(6);
    for (int i = 0; i < 400; ++i) {
      // About a core, where several faces are about equally near.
      const Vec3 about = head.cores[random.below(head.cores.size())] + random.point(1);
      std::array<Vec3, 6> corners;
      for (Vec3& corner : corners) corner = about + (i % 3 == 0 ? 0.05 : 3) * random.point(1);
      const double bulge = i % 2 == 0 ? 0 : random.in(0, 0.1);
      const PieceRegion region(corners, bulge);
      const auto first = head.supports.plane(static_cast<std::uint32_t>(random.below(mesh.triangles.size())));
      const auto second = head.supports.plane(static_cast<std::uint32_t>(random.below(mesh.triangles.size())));
      if (!first || !second) continue;
      const CornerDepths a = corner_depths(region, *first), b = corner_depths(region, *second);
      const double bound = depth_by_two_supports(region, a, b);
      const double alone = std::min(depth_by_support(region, *first), depth_by_support(region, *second));
      ASSERT_LE(bound, alone + 1e-8);
      ASSERT_LE(least_depth(a, b), bound);
      better += bound < alone - 1e-6 ? 1 : 0;
      // The least of all means.
      double least = alone;
      for (int share = 0; share <= 1000; ++share) {
        double most = 0;
        for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, b[k] + 1e-3 * share * (a[k] - b[k]));
        least = std::min(least, most + bulge);
      }
      ASSERT_LE(bound, least + 1e-8) << mesh.name << i;
      for (int k = 0; k < 60; ++k) {
        double sum = 0;
        Vec3 q = Vec3::Zero();
        for (const Vec3& corner : corners) {
          const double share = random.in(0, 1);
          sum += share;
          q += share * corner;
        }
        const double depth = -head.surface.closest_point(q / sum + bulge * random.direction())->signed_mm();
        ASSERT_LE(depth, bound + 1e-9) << mesh.name << i;
        deep += depth > 0.1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(better, 100u);
  EXPECT_GT(deep, 1000u);
}

}  // namespace
}  // namespace gouge::support_planes_test
