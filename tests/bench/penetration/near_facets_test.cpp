#include "tests/bench/penetration/near_facets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/penetration/depth_body.h"
#include "tests/lib/penetration/brute_foot.h"
#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"

namespace gouge::near_facets_test {
namespace {

double distance_to(const DepthBody& body, std::uint32_t place, const Vec3& point) {
  return std::sqrt(closest_on_triangle(point, body.corners[place]).distance2_mm2);
}

struct Tally {
  std::size_t complete = 0, seeds = 0, listed = 0;
};

/// Every list stated to be complete holds the nearest facet of every point of its cell; the others a facet.
Tally expect_nearest(const IndexedMesh& mesh, double depth_mm, int points) {
  DepthBodyOptions options;
  options.depth_mm = depth_mm;
  const DepthBody body = build_depth_body(Surface(IndexedMesh(mesh)), options);
  const NearFacets near(body);
  RandomPoints random(body.mesh(), 2 * depth_mm, 9);
  const double rounding = 1e-9 + 1e-12 * mesh.box().max().cwiseAbs().maxCoeff();
  Tally tally;
  for (int i = 0; i < points; ++i) {
    const Vec3 point = random.next();
    const NearFacets::Known known = near.at(body.depths.cell_of(point));
    if (known.facets.empty()) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t facet : known.facets) least = std::min(least, distance_to(body, near.slot(facet), point));
    const double truth = brute_force_closest_point(body.mesh(), point).distance_mm;
    EXPECT_GE(least, truth - rounding);
    if (known.is_complete) {
      EXPECT_LE(least, truth + rounding) << mesh.name << " " << point.transpose();
    }
    (known.is_complete ? tally.complete : tally.seeds) += 1;
    tally.listed += known.facets.size();
  }
  return tally;
}

TEST(NearFacets, HoldTheNearestOfEveryPointOfTheCell) {
  for (const IndexedMesh& mesh :
       {shapes::star_prism(), shapes::slotted_block(), shapes::torus(), shapes::hollow_cube(20)}) {
    const Tally tally = expect_nearest(mesh, 1.5, 3000);
    EXPECT_GT(tally.complete, 800U) << mesh.name;
    EXPECT_LT(tally.listed, 4 * tally.complete) << mesh.name << ": lists too long to be of use";
  }
}

TEST(NearFacets, HoldItFarFromTheOriginToo) {
  IndexedMesh mesh = shapes::bumpy_sphere();
  for (Vec3& v : mesh.vertices) v += Vec3(1e5, -1e5, 1e5);
  EXPECT_GT(expect_nearest(mesh, 1.5, 1000).complete, 400U);
}

TEST(NearFacets, ReportOnlyOneWhereFacetsAreSmallAgainstTheCells) {
  const Tally tally = expect_nearest(shapes::needle_fan(400), 2, 1500);
  EXPECT_GT(tally.seeds, 100U);
}

TEST(FacetPlanes, ReportTheHeightOverAFacetAndBoundTheDistanceBesideIt) {
  const IndexedMesh mesh = shapes::star_prism();
  RandomPoints random(mesh, 5, 6);
  std::size_t over = 0, beside = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::size_t t = static_cast<std::size_t>(i) % mesh.triangles.size();
    const std::array<Vec3, 3> corners = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const Vec3 point = random.next();
    const FacetPlanes::Heights heights = facet_planes(corners, normal).at(point);
    const double distance = std::sqrt(closest_on_triangle(point, corners).distance2_mm2);
    if (heights.beyond_mm < -1e-9) {
      ++over;
      ASSERT_NEAR(std::abs(heights.over_mm), distance, 1e-10);
    } else {
      ++beside;
      const double beyond = std::max(0.0, heights.beyond_mm);
      ASSERT_LE(std::sqrt(heights.over_mm * heights.over_mm + beyond * beyond), distance + 1e-10);
    }
  }
  EXPECT_GT(over, 500U);
  EXPECT_GT(beside, 500U);
}

TEST(FacetPlanes, SayNothingOfANeedle) {
  const std::array<Vec3, 3> needle = {Vec3(0, 0, 0), Vec3(100, 0, 0), Vec3(50, 1e-7, 0)};
  const FacetPlanes::Heights heights = facet_planes(needle, Vec3::UnitZ()).at(Vec3(50, 0, 7));
  EXPECT_EQ(heights.over_mm, 0);
  EXPECT_EQ(heights.beyond_mm, 0);
}

}  // namespace
}  // namespace gouge::near_facets_test
