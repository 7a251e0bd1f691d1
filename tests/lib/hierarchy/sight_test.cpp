#include "lib/hierarchy/sight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::sight_test {
namespace {

/// How surely the ray meets a triangle: the least of its shares of the corners where it meets the plane, and of the way
/// there; negative where it misses.
double surely_met(const IndexedMesh& mesh, std::size_t t, const Vec3& from, const Vec3& toward) {
  const Vec3& a = mesh.corner(t, 0);
  Eigen::Matrix3d m;
  m << mesh.corner(t, 1) - a, mesh.corner(t, 2) - a, -toward;
  if (std::abs(m.determinant()) < 1e-12) return -1e-9;
  const Vec3 x = m.inverse() * (from - a);
  return std::min({x[0], x[1], 1 - x[0] - x[1], x[2]});
}

TEST(Sight, IsBlockedByWhatARayMeets) {
  test::Scatter random(7);
  for (IndexedMesh mesh : {shapes::cube(), shapes::sphere(), shapes::torus(), shapes::needle_fan()}) {
    for (Vec3& v : mesh.vertices) v += Vec3(300, -40, 7);
    const BlockTree tree = build_block_tree({&mesh, 1});
    const Box3 box = mesh.box();
    const double size = box.diagonal().norm();
    int hidden = 0, seen = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec3 point = box.center() + size * random.point(1);
      const Vec3 toward = (random.point(1) + Vec3(1e-3, 0, 0)).normalized();
      const double clear = 0.1 * size;
      double most = -1;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        most = std::max(most, surely_met(mesh, t, point + clear * toward, toward));
      if (std::abs(most) < 1e-3) continue;  // within rounding of an edge
      EXPECT_EQ(is_hidden(tree, point, toward, clear), most > 0) << mesh.name << " " << k;
      (most > 0 ? hidden : seen) += 1;
    }
    EXPECT_GT(seen, 100) << mesh.name;
    if (mesh.name != shapes::needle_fan().name) {
      EXPECT_GT(hidden, 20) << mesh.name;
    }
  }
}

TEST(Sight, IsFreeWithoutTriangles) { EXPECT_FALSE(is_hidden(BlockTree{}, Vec3::Zero(), Vec3::UnitZ(), 0)); }

}  // namespace
}  // namespace gouge::sight_test
