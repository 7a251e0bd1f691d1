#include "tests/bench/penetration/thesis_modes.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/lib/penetration/depth_error.h"
#include "tests/support/solids.h"

namespace gouge::thesis_modes_test {
namespace {

Error error_of_mode(const IndexedMesh& mesh, double depth_mm, ThesisMode mode) {
  DepthBodyOptions options;
  options.depth_mm = depth_mm;
  options.coverage = Coverage::offset;
  const DepthBody body = build_depth_body(Surface(IndexedMesh(mesh)), options);
  const ThesisModes modes(body);
  const std::vector<Vec3> points = shallow_points(mesh, depth_mm);
  std::vector<double> found;
  for (const Vec3& point : points) found.push_back(modes.depth_mm(point, mode).value_or(-1));
  return error_of(body, points, found);
}

TEST(ThesisModes, AreGoodOnASmoothPartWithinItsSafeDepth) {
  const IndexedMesh mesh = shapes::bumpy_sphere();
  const Error planes = error_of_mode(mesh, 0.5, ThesisMode::planes);
  const Error implicit = error_of_mode(mesh, 0.5, ThesisMode::volumes);
  for (const auto& [name, e] : {std::pair{"planes", planes}, std::pair{"volumes alone", implicit}}) {
    std::cout << name << ": " << e.inside << " inside, missed " << e.missed << ", false " << e.false_alarms
              << ", mean error " << e.sum_mm / static_cast<double>(e.inside) << ", largest " << e.largest_mm << " mm\n";
    EXPECT_LT(e.sum_mm / static_cast<double>(e.inside), 0.01) << name;
    EXPECT_LT(e.missed, e.inside / 20) << name;
  }
}

TEST(Bisectors, StandBetweenCoplanarFacesAndAtRightAngles) {
  DepthBodyOptions options;
  options.leaf_triangles = 4;
  const DepthBody body = build_depth_body(Surface(shapes::cube(10)), options);
  const ThesisModes modes(body);
  for (std::size_t place = 0; place < body.corners.size(); ++place) {
    const Vec3 up = body.surface.face_normal(body.tree.order[place]);
    const Vec3 centre = (body.corners[place][0] + body.corners[place][1] + body.corners[place][2]) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& n = modes.bisectors(place)[k];
      EXPECT_NEAR(n.norm(), 1, 1e-12);
      EXPECT_GT(n.dot(centre - body.corners[place][k]), 0) << "the facet lies on its own side";
      const double lean = n.dot(up);
      EXPECT_TRUE(std::abs(lean) < 1e-12 || std::abs(lean - std::sqrt(0.5)) < 1e-12) << lean;
    }
  }
}

}  // namespace
}  // namespace gouge::thesis_modes_test
