#include "lib/penetration/narrow_phase.h"

#include <gtest/gtest.h>

#include "lib/penetration/find_penetration.h"
#include "tests/lib/penetration/depth_error.h"
#include "tests/support/solids.h"

namespace gouge::narrow_phase_test {
namespace {

TEST(NarrowPhase, MissesNothingAndFindsNothingFalse) {
  for (const IndexedMesh& mesh :
       {shapes::star_prism(), shapes::slotted_block(), shapes::torus(), shapes::bumpy_sphere()}) {
    DepthBodyOptions options;
    options.depth_mm = 1.2;
    const DepthBody body = build_depth_body(Surface(IndexedMesh(mesh)), options);
    const std::vector<Vec3> points = shallow_points(mesh, options.depth_mm);
    const PointBody moving = build_point_body(points);
    PenetrationFinder finder(body, moving, {0, false});
    std::vector<double> found(points.size(), -1);
    for (const PointContact& c : finder.find({}).contacts) found[c.point] = c.contact.depth_mm;
    const Error error = error_of(body, points, found);
    EXPECT_GT(error.inside, 1000U);
    EXPECT_EQ(error.missed + error.false_alarms, 0U) << mesh.name;
    EXPECT_LT(error.largest_mm, 1e-9) << mesh.name;
  }
}

}  // namespace
}  // namespace gouge::narrow_phase_test
