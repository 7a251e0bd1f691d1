#include "lib/surface/known_sides.h"

#include <gtest/gtest.h>

#include "lib/mesh/winding.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge {
namespace {

std::vector<IndexedMesh> solids() {
  const IndexedMesh outer = shapes::box(Vec3::Constant(-10), Vec3::Constant(10));
  const IndexedMesh inner = shapes::box(Vec3::Constant(-4), Vec3::Constant(4));
  return {outer,
          shapes::joined(outer, inner),
          shapes::joined(outer, shapes::inside_out(inner)),
          shapes::joined(outer, shapes::moved(inner, Vec3(9, 1, 2))),
          shapes::joined(outer, shapes::moved(shapes::sphere(6, 12, 16), Vec3(-8, 0, 3))),
          shapes::sphere(10, 12, 16)};
}

TEST(KnownSides, AreThoseOfTheWindingNumber) {
  test::Scatter random(3);
  std::size_t otherwise = 0;
  for (const IndexedMesh& mesh : solids()) {
    const Surface surface(mesh, 1);
    KnownSides sides(surface);
    Vec3 point = Vec3::Zero();
    std::uint32_t near = 0;
    for (int k = 0; k < 3000; ++k) {
      point = random.is(0.2) ? random.point(14) : Vec3(point + random.point(1));
      const bool is_in = winding_number(mesh, point) > 0.5;
      const ClosestPoint foot = random.is(0.5) ? sides.closest_point(point) : sides.closest_point_from(point, near);
      const ClosestPoint simple = *surface.closest_point(point);
      near = foot.triangle;
      if (foot.distance_mm < 1e-6) continue;
      EXPECT_EQ(foot.is_inside, is_in) << point.transpose();
      EXPECT_EQ(surface.winds_around(point), is_in) << point.transpose();
      EXPECT_DOUBLE_EQ(foot.distance_mm, simple.distance_mm);
      EXPECT_LT((point - foot.signed_mm() * foot.normal - foot.point).norm(), 1e-9);
      otherwise += simple.is_inside != is_in ? 1U : 0U;
    }
  }
  EXPECT_GT(otherwise, 100U) << "points whose nearest triangle shows the wrong side";
}

// Rays from here meet edges and corners of the box in each of their directions, or run along faces.
TEST(KnownSides, DoNotDependOnEdgesThatARayMeets) {
  const IndexedMesh mesh = shapes::box(Vec3::Constant(-1), Vec3::Constant(1));
  const Surface surface(mesh, 1);
  const auto along = [](double x, double y, double z) { return Vec3(x, y, z).normalized(); };
  for (const Vec3& direction : {along(0.1719, 0.2831, 0.9435), along(0.9187, -0.3541, 0.1747)}) {
    for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, 1, 0.25), Vec3(0, 1, -1), Vec3(1, 1, -1)}) {
      for (const double back : {0.0, 0.5, 1.0, 4.0}) {
        const Vec3 point = 0.999 * corner - back * direction;
        EXPECT_EQ(surface.winds_around(point), point.cwiseAbs().maxCoeff() < 1) << point.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace gouge
