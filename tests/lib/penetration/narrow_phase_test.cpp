#include <gtest/gtest.h>

#include <iostream>

#include "lib/penetration/find_penetration.h"
#include "lib/penetration/nearest_foot.h"
#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"

namespace gouge {
namespace {

struct Error {
  std::size_t inside = 0, missed = 0, false_alarms = 0;
  double largest_mm = 0, sum_mm = 0;
};

/// One mode against the nearest foot, over random shallow points.
Error error_of(const IndexedMesh& mesh, double depth_mm, NarrowMode mode, Coverage coverage) {
  DepthBodyOptions options;
  options.depth_mm = depth_mm;
  options.coverage = coverage;
  const DepthBody body = build_depth_body(mesh, options);
  RandomPoints random(mesh, 0.8 * depth_mm, 11);
  std::vector<Vec3> points;
  for (int i = 0; i < 4000; ++i) points.push_back(random.next());
  const PointBody moving = build_point_body(points);
  PenetrationFinder finder(body, moving, {mode, 0, false});
  const PenetrationAnswer& answer = finder.find({});
  std::vector<double> told(points.size(), -1);
  for (const PointContact& c : answer.contacts) told[c.point] = c.contact.depth_mm;
  Error error;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto foot = nearest_foot(body, points[i]);
    if (foot->distance_mm < 1e-6) continue;
    if (!foot->is_inside) {
      error.false_alarms += told[i] >= 0 ? 1U : 0U;
      continue;
    }
    ++error.inside;
    error.missed += told[i] < 0 ? 1U : 0U;
    if (told[i] < 0) continue;
    const double off = std::abs(told[i] - foot->distance_mm);
    error.largest_mm = std::max(error.largest_mm, off);
    error.sum_mm += off;
  }
  return error;
}

TEST(NarrowModes, OnlyTheExactOneMissesNothingAndTellsNothingFalse) {
  for (const IndexedMesh& mesh :
       {shapes::star_prism(), shapes::slotted_block(), shapes::torus(), shapes::bumpy_sphere()}) {
    const Error exact = error_of(mesh, 1.2, NarrowMode::exact, Coverage::complete);
    EXPECT_GT(exact.inside, 1000U);
    EXPECT_EQ(exact.missed + exact.false_alarms, 0U) << mesh.name;
    EXPECT_LT(exact.largest_mm, 1e-9) << mesh.name;
  }
}

TEST(NarrowModes, PlanesAndVolumesAreGoodOnASmoothPartWithinItsSafeDepth) {
  const IndexedMesh mesh = shapes::bumpy_sphere();
  const Error planes = error_of(mesh, 0.5, NarrowMode::planes, Coverage::offset);
  const Error implicit = error_of(mesh, 0.5, NarrowMode::implicit, Coverage::offset);
  for (const auto& [name, e] : {std::pair{"planes", planes}, std::pair{"volumes alone", implicit}}) {
    std::cout << name << ": " << e.inside << " inside, missed " << e.missed << ", false " << e.false_alarms
              << ", mean error " << e.sum_mm / static_cast<double>(e.inside) << ", largest " << e.largest_mm
              << " mm\n";
    EXPECT_LT(e.sum_mm / static_cast<double>(e.inside), 0.01) << name;
    EXPECT_LT(e.missed, e.inside / 20) << name;
  }
}

TEST(Bisectors, StandBetweenCoplanarFacesAndAtRightAngles) {
  DepthBodyOptions options;
  options.leaf_triangles = 4;
  const DepthBody body = build_depth_body(shapes::cube(10), options);
  for (std::size_t place = 0; place < body.corners.size(); ++place) {
    const Vec3& up = body.sign.face(body.tree.order[place]);
    const Vec3 centre = (body.corners[place][0] + body.corners[place][1] + body.corners[place][2]) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& n = body.bisectors[place][k];
      EXPECT_NEAR(n.norm(), 1, 1e-12);
      EXPECT_GT(n.dot(centre - body.corners[place][k]), 0) << "the facet lies on its own side";
      const double lean = n.dot(up);
      EXPECT_TRUE(std::abs(lean) < 1e-12 || std::abs(lean - std::sqrt(0.5)) < 1e-12) << lean;
    }
  }
}

}  // namespace
}  // namespace gouge
