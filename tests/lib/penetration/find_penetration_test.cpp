#include <gtest/gtest.h>

#include "lib/kdop/kdop_corners.h"
#include "lib/penetration/find_penetration.h"
#include "lib/surface/surface.h"
#include "tests/bench/penetration/normal_methods.h"
#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"
#include "tests/support/verify_kdop_tree.h"

namespace gouge::find_penetration_test {
namespace {

DepthBody cube_body(double depth = 2) {
  DepthBodyOptions options;
  options.depth_mm = depth;
  return build_depth_body(Surface(shapes::refined(shapes::cube(20), 3)), options);
}

RigidTransform moved_by(const Vec3& shift) {
  RigidTransform pose;
  pose.shift = shift;
  return pose;
}

TEST(FindPenetration, ReportsPointDepthAndTheWayOut) {
  const DepthBody body = cube_body();
  const PointBody points = build_point_body(std::vector<Vec3>{Vec3(0, 0, 0), Vec3(0, 0, 5)});
  PenetrationFinder finder(body, points, {7, true});
  const PenetrationResult& result = finder.find(moved_by(Vec3(9, 11, 19.25)));
  ASSERT_EQ(result.contacts.size(), 1U);
  const PointContact& c = result.contacts[0];
  EXPECT_EQ(c.point, 0U);
  EXPECT_EQ(c.contact.body, 7U);
  EXPECT_NEAR(c.contact.depth_mm, 0.75, 1e-12);
  EXPECT_NEAR((c.contact.normal - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR((c.contact.point - Vec3(9, 11, 19.25)).norm(), 0, 1e-12);
  EXPECT_FALSE(c.is_deeper);
  EXPECT_NEAR(body.mesh().corner(c.contact.triangle, 0).z(), 20, 1e-12);
}

TEST(FindPenetration, SaysDeeperThanDAndNeverNothing) {
  const DepthBody body = cube_body(2);
  for (const double depth : {1.9, 2.1, 5.0, 9.9}) {
    const PointBody points = build_point_body(std::vector<Vec3>{Vec3::Zero()});
    PenetrationFinder finder(body, points);
    const PenetrationResult& result = finder.find(moved_by(Vec3(10, 10, 20 - depth)));
    ASSERT_EQ(result.contacts.size(), 1U) << depth;
    EXPECT_EQ(result.contacts[0].is_deeper, depth > 2) << depth;
    EXPECT_NEAR(result.contacts[0].contact.depth_mm, depth, 1e-9);
  }
}

TEST(FindPenetration, ReportsALumpWhollyInsideFarFromTheSurface) {
  const DepthBody body = cube_body(1);
  const PointBody points = build_point_body(shapes::sphere(2).vertices);
  PenetrationFinder finder(body, points);
  const PenetrationResult& result = finder.find(moved_by(Vec3(10, 10, 10)));
  EXPECT_EQ(result.contacts.size(), points.points.size());
  EXPECT_TRUE(result.contacts.front().is_deeper);
}

TEST(FindPenetration, OfBodiesApartIsEmptyAndCheap) {
  const DepthBody body = cube_body();
  const PointBody points = build_point_body(shapes::sphere(5, 24, 24).vertices);
  PenetrationFinder finder(body, points);
  const PenetrationResult& result = finder.find(moved_by(Vec3(60, 0, 0)));
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_EQ(result.counters.volumes_updated, 1U);
  EXPECT_EQ(result.counters.volume_pairs, 1U);
  EXPECT_EQ(result.counters.points_transformed, 0U);
}

TEST(FindPenetration, UpdatesOnlyWhatIsVisitedAndShiftsWhatWasTurned) {
  const DepthBody body = cube_body();
  const PointBody points = build_point_body(shapes::sphere(15, 40, 60).vertices);
  PenetrationFinder finder(body, points);
  const PenetrationCounters first = finder.find(moved_by(Vec3(10, 10, 34))).counters;
  EXPECT_LT(first.volumes_updated, points.tree.nodes.size());
  EXPECT_GT(first.corners_transformed, 0U);
  EXPECT_EQ(first.volumes_shifted, 0U);
  const PenetrationCounters second = finder.find(moved_by(Vec3(10.1, 10, 34))).counters;
  EXPECT_LT(second.corners_transformed, first.corners_transformed / 4);
  EXPECT_GT(second.volumes_shifted, 0U);
}

TEST(FindPenetration, GivesTheSameResultWhetherVolumesAreShiftedOrTurnedAnew) {
  const DepthBody body = cube_body();
  const PointBody points = build_point_body(shapes::star_prism().vertices);
  PenetrationFinder kept(body, points);
  RandomPoints random(body.mesh(), 1, 3);
  RigidTransform pose = random.pose(10);
  for (int i = 0; i < 50; ++i) {
    pose.shift += 2 * random.direction();
    PenetrationFinder fresh(body, points);
    const PenetrationResult& a = kept.find(pose);
    const PenetrationResult& b = fresh.find(pose);
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    for (std::size_t k = 0; k < a.contacts.size(); ++k)
      EXPECT_EQ(a.contacts[k].contact.depth_mm, b.contacts[k].contact.depth_mm);
  }
}

TEST(FindPenetration, WithoutPointsIsEmpty) {
  const DepthBody body = cube_body();
  const PointBody none = build_point_body(std::vector<Vec3>{});
  PenetrationFinder finder(body, none);
  EXPECT_TRUE(finder.find({}).contacts.empty());
}

TEST(PointBody, GivesNoNodeAVolumeThatCostsMoreThanItsContent) {
  const std::vector<Vec3> cloud = shapes::bumpy_sphere().vertices;
  const PointBody weighed = build_point_body(cloud);
  PointBodyOptions all;
  all.is_cost_weighed = false;
  const PointBody every = build_point_body(cloud, all);
  std::size_t with = 0;
  for (std::size_t n = 0; n < weighed.tree.nodes.size(); ++n) {
    EXPECT_LE(weighed.corner_count[n], weighed.tree.nodes[n].item_count);
    with += weighed.corner_count[n] > 0 ? 1U : 0U;
    EXPECT_GT(every.corner_count[n], 0U);
  }
  EXPECT_GT(with, 3U);
  EXPECT_LT(with, weighed.tree.nodes.size());
}

TEST(DepthBody, OffsetVolumesHoldTheFacetsAndTheirOffsets) {
  DepthBodyOptions options;
  options.coverage = Coverage::offset;
  options.depth_mm = 1.5;
  for (const auto normals : {&offset_averaged, &offset_by_paraboloid, &offset_by_planes}) {
    options.offset_vertices = normals;
    const DepthBody body = build_depth_body(Surface(shapes::star_prism()), options);
    EXPECT_EQ(test::verify_kdop_tree(body.tree), std::vector<std::string>{});
    for (std::size_t n = 0; n < body.tree.nodes.size(); ++n) {
      const KdopNode& node = body.tree.nodes[n];
      if (node.children > 0) continue;
      for (const Corner c : body.mesh().triangles[body.tree.order[node.first]]) {
        for (const double depth : {0.0, 1.5}) {
          const Vec3 p = body.mesh().vertices[c] - depth * body.offsets[c].move;
          for (std::size_t i = 0; i < 13; ++i) {
            const double at = body.tree.directions.axes[i].dot(p);
            EXPECT_LE(static_cast<double>(body.tree.bounds_of(n)[low_slot(i)]), at);
            EXPECT_GE(static_cast<double>(body.tree.bounds_of(n)[high_slot(i)]), at);
          }
        }
      }
    }
  }
}

TEST(DepthBody, OfAFacetAcrossADirectionHasThickness) {
  // Figure 29: the top of a cube seen along z.
  const DepthBody body = cube_body(2);
  for (std::size_t n = 0; n < body.tree.nodes.size(); ++n) {
    const float* const volume = body.tree.bounds_of(n);
    EXPECT_GE(volume[high_slot(2)] - volume[low_slot(2)], 1.99F);
  }
}

}  // namespace
}  // namespace gouge::find_penetration_test
