#include <gtest/gtest.h>

#include "lib/penetration/find_penetration.h"
#include "lib/penetration/point_body.h"
#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"

namespace gouge::surface_points_test {
namespace {

TEST(SurfacePoints, LeaveNoPointOfTheSurfaceFartherThanTheSpacing) {
  for (const IndexedMesh& mesh : {shapes::cube(10), shapes::needle_fan(40), shapes::star_prism()}) {
    for (const double spacing : {4.0, 0.7}) {
      const std::vector<Vec3> points = surface_points(mesh, spacing);
      RandomPoints random(mesh, 0, 5);
      double farthest = 0;
      for (int i = 0; i < 500; ++i) {
        const Vec3 p = random.next();
        double nearest = 1e300;
        for (const Vec3& q : points) nearest = std::min(nearest, (p - q).norm());
        farthest = std::max(farthest, nearest);
      }
      EXPECT_LE(farthest, spacing) << mesh.name;
    }
  }
}

TEST(SurfacePoints, FindASpikeThatPiercesAFaceWhereVerticesAloneDoNot) {
  // A pyramid's tip through the middle of a large face: no vertex of the moving block is inside.
  const IndexedMesh pyramid = shapes::needle_fan(4, 10, 12);
  const DepthBody body = build_depth_body(Surface(IndexedMesh(pyramid)), {});
  const IndexedMesh block = shapes::box(Vec3(-50, -50, 8), Vec3(50, 50, 60));
  const PointBody vertices = build_point_body(block.vertices);
  PenetrationFinder alone(body, vertices);
  EXPECT_TRUE(alone.find({}).contacts.empty());
  const double spacing = 1;
  const std::vector<Vec3> points = surface_points(block, spacing);
  const PointBody covered = build_point_body(points);
  PenetrationFinder finder(body, covered);
  double deepest = 0;
  for (const PointContact& c : finder.find({}).contacts) deepest = std::max(deepest, c.contact.depth_mm);
  // The face is deepest on the pyramid's axis, 4 below its tip.
  const double truth = 4 * std::sin(std::atan2(10 * std::sqrt(0.5), 12));
  EXPECT_LE(deepest, truth + 1e-9);
  EXPECT_GE(deepest + spacing, truth);
  EXPECT_GT(deepest, 0.5);
}

}  // namespace
}  // namespace gouge::surface_points_test
