#include "lib/mesh/enclosure.h"

#include <gtest/gtest.h>

#include "lib/mesh/body_pieces.h"
#include "lib/mesh/ray_cone.h"
#include "tests/support/crossing_parity.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::enclosure_test {
namespace {

Side side_in(const std::vector<IndexedMesh>& meshes, const Vec3& point) {
  return Enclosure(meshes).side_of({{point}, {Vec3::UnitZ()}});
}

TEST(Enclosure, AgreesWithCrossingsOnClosedSolids) {
  test::Scatter random(5);
  for (const IndexedMesh& mesh : {shapes::torus(20, 6), shapes::star_prism(), shapes::sphere(15)}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 p(random.in(-27, 27), random.in(-27, 27), random.in(-8, 14));
      EXPECT_EQ(side_in({mesh}, p), test::is_inside(mesh, p) ? Side::inside : Side::outside) << p.transpose();
    }
  }
}

TEST(Enclosure, BeyondTheBoxIsOutsideHoweverBrokenTheMesh) {
  EXPECT_EQ(side_in({shapes::open_cube(10)}, Vec3(5, 5, 10.001)), Side::outside);
  EXPECT_EQ(side_in({shapes::open_cube(10)}, Vec3(5, 5, 5)), Side::unknown);
  EXPECT_EQ(side_in({}, Vec3(5, 5, 5)), Side::outside);
}

TEST(Enclosure, APlaceThatIsJoinedWithOneBeyondIsOutside) {
  const std::vector<IndexedMesh> pot = {shapes::open_cube(10)};
  EXPECT_EQ(Enclosure(pot).side_of({{Vec3(5, 5, 5), Vec3(5, 5, 11)}, {Vec3::UnitZ()}}), Side::outside);
}

TEST(Enclosure, PiecesWithHolesConcernOnlyPlacesInTheirBox) {
  const IndexedMesh both = shapes::joined(shapes::open_cube(10), shapes::moved(shapes::cube(10), Vec3(30, 0, 0)));
  EXPECT_EQ(side_in({both}, Vec3(35, 5, 5)), Side::inside);
  EXPECT_EQ(side_in({both}, Vec3(20, 5, 5)), Side::outside);
  EXPECT_EQ(side_in({both}, Vec3(5, 5, 8)), Side::unknown);
}

TEST(Enclosure, ASmallHoleLeavesTheInsideKnownFarFromIt) {
  IndexedMesh holed = shapes::sphere(10, 20, 40);
  holed.triangles.erase(holed.triangles.begin() + 400);
  holed.file_triangle.pop_back();
  EXPECT_EQ(side_in({holed}, Vec3(0, 0, 0)), Side::inside);
  EXPECT_NE(side_in({holed}, Vec3(9, 9, 0)), Side::inside);
}

TEST(Enclosure, ACavityIsOutsideAndAWallWrittenTwiceIsNone) {
  const IndexedMesh block = shapes::cube(10);
  const auto with = [&](double low, double high) {
    return shapes::joined(block, shapes::inside_out(shapes::box(Vec3::Constant(low), Vec3::Constant(high))));
  };
  EXPECT_EQ(side_in({with(2.5, 7.5)}, Vec3(5, 5, 5)), Side::outside);
  EXPECT_TRUE(Cavities(with(2.5, 7.5)).contain(Vec3(5, 5, 5)));
  EXPECT_EQ(side_in({with(2.5, 7.5)}, Vec3(1, 5, 5)), Side::inside);
  EXPECT_EQ(side_in({with(0.001, 9.999)}, Vec3(5, 5, 5)), Side::unknown);
  EXPECT_EQ(side_in({with(0, 10)}, Vec3(5, 5, 5)), Side::unknown);
  EXPECT_EQ(side_in({with(-1, 11)}, Vec3(5, 5, 5)), Side::unknown);
  EXPECT_EQ(side_in({with(5, 15)}, Vec3(7, 7, 7)), Side::unknown);
}

TEST(Enclosure, BodiesThatTouchOrOverlapAreInside) {
  EXPECT_EQ(side_in({shapes::cubes_crossing(10)}, Vec3(7, 7, 7)), Side::inside);
  EXPECT_EQ(side_in({shapes::cubes_touching_at_edge(10)}, Vec3(5, 5, 5)), Side::inside);
  EXPECT_EQ(side_in({shapes::cubes_touching_at_edge(10)}, Vec3(15, 5, 5)), Side::outside);
  EXPECT_EQ(side_in({shapes::cube(10), shapes::moved(shapes::cube(10), Vec3(10, 0, 0))}, Vec3(15, 5, 5)), Side::inside);
}

/// Open above, with the other diagonal of each face.
IndexedMesh open_cube_with_other_diagonals() {
  IndexedMesh mesh = shapes::open_cube(10);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2) {
    const TriangleCorners a = mesh.triangles[t], b = mesh.triangles[t + 1];  // p q r and p r s
    mesh.triangles[t] = {a[0], a[1], b[2]};
    mesh.triangles[t + 1] = {a[1], a[2], b[2]};
  }
  return mesh;
}

TEST(Enclosure, AnOpenSurfaceThatStandsThereSeveralTimesProvesNoOutside) {
  const IndexedMesh once = shapes::open_cube(10), other = open_cube_with_other_diagonals();
  const Vec3 within(5, 4, 5);
  for (const IndexedMesh& second : {once, shapes::inside_out(once), other, shapes::inside_out(other)}) {
    EXPECT_NE(side_in({once, second}, within), Side::outside);
    EXPECT_NE(side_in({shapes::joined(once, second)}, within), Side::outside);
    EXPECT_NE(side_in({once, once, second}, within), Side::outside);
    EXPECT_NE(side_in({once, second, second, other}, within), Side::outside);
  }
}

TEST(Enclosure, ADoubleWallIsOneEvenWhereItsSheetsLieALittleApart) {
  IndexedMesh shaken = shapes::torus(20, 6);
  const std::size_t count = shaken.triangles.size();
  IndexedMesh both = shaken;
  for (std::size_t t = 20; t < count; ++t) {  // a second sheet over all but a hole's rim
    const TriangleCorners c = shaken.triangles[t];
    both.vertices.push_back((shaken.corner(t, 0) + shaken.corner(t, 1) + shaken.corner(t, 2)) / 3 +
                            Vec3(1e-5, 0, 1e-5));
    for (std::size_t k = 0; k < 3; ++k) shapes::add_triangle(both, c[(k + 1) % 3], c[k], both.vertices.size() - 1);
  }
  both.triangles.erase(both.triangles.begin(), both.triangles.begin() + 20);
  ASSERT_EQ(find_edge_faults(both).open, 0U);
  EXPECT_NE(side_in({both}, Vec3(-20, 0, 0)), Side::outside);
}

TEST(Enclosure, WhatIsClosedProvesAnOutsideHoweverOftenItStandsThere) {
  const IndexedMesh ring = shapes::torus(20, 6);
  const Vec3 beside(1, 2, 0);
  ASSERT_EQ(side_in({ring}, beside), Side::outside);
  EXPECT_EQ(side_in({ring, ring}, beside), Side::outside);
  EXPECT_EQ(side_in({ring, shapes::inside_out(ring)}, beside), Side::outside);
  EXPECT_EQ(side_in({shapes::joined(ring, ring)}, beside), Side::outside);
  EXPECT_EQ(side_in({ring, ring, shapes::inside_out(ring)}, beside), Side::outside);
  // Stacked bodies with a face in common, in one file.
  const IndexedMesh low = shapes::cube(10);
  const IndexedMesh stacked =
      shapes::joined(shapes::joined(low, shapes::moved(low, Vec3(0, 0, 10))), shapes::moved(low, Vec3(10, 0, 0)));
  EXPECT_EQ(side_in({stacked}, Vec3(15, 5, 15)), Side::outside);
  EXPECT_EQ(side_in({stacked}, Vec3(5, 5, 15)), Side::inside);
}

TEST(Enclosure, AFileInsideOutIsNoCavityOfAnother) {
  const IndexedMesh block = shapes::cube(10), insert = shapes::box(Vec3::Constant(2.5), Vec3::Constant(7.5));
  const Vec3 within(5, 5, 5);
  EXPECT_EQ(side_in({block, shapes::inside_out(insert)}, within), Side::inside);
  EXPECT_EQ(side_in({shapes::joined(block, shapes::inside_out(insert))}, within), Side::outside);
  // A file's own cavity, with other files beside it and the same file twice.
  const IndexedMesh hollow = shapes::hollow_cube(10), far = shapes::moved(block, Vec3(50, 0, 0));
  EXPECT_EQ(side_in({far, hollow}, within), Side::outside);
  EXPECT_EQ(side_in({hollow, hollow}, within), Side::outside);
  // Filled by a part that is inside out: not empty.
  EXPECT_EQ(side_in({hollow, shapes::inside_out(shapes::box(Vec3::Constant(4), Vec3::Constant(6)))}, within),
            Side::inside);
}

TEST(BodyPieces, ABossThatStandsThereTwiceOnAnOpenBlockIsDoubtfulLikeTheBlock) {
  IndexedMesh scene = shapes::cube(10);
  scene.triangles.erase(scene.triangles.begin());  // a triangle of the bottom
  IndexedMesh boss = shapes::moved(shapes::inside_out(shapes::open_cube(10)), Vec3(0, 0, 10));
  for (Vec3& v : boss.vertices) v.z() = 30 - v.z();  // open below, on the top of the block
  for (const IndexedMesh& second : {boss, shapes::inside_out(boss)}) {
    const std::vector<IndexedMesh> files = {scene, boss, second};
    EXPECT_NE(side_in(files, Vec3(5, 5, 5)), Side::outside);
    const BodyPieces pieces = find_body_pieces(weld_together(files).mesh);
    EXPECT_FALSE(pieces.doubtful_box.isEmpty());
  }
}

TEST(FreeRay, WhatRoundingCouldTurnIntoAHitIsOne) {
  const IndexedMesh cube = shapes::cube(10);
  const std::vector<Vec3> up = {Vec3::UnitZ()}, inside = {Vec3(5, 5, 5)}, above = {Vec3(5, 5, 11)};
  EXPECT_FALSE(has_free_ray(cube, inside, up));
  EXPECT_TRUE(has_free_ray(cube, above, up));
  // Along an edge, through a corner, along a face.
  EXPECT_FALSE(has_free_ray(cube, std::vector<Vec3>{Vec3(10, 10, -5)}, up));
  EXPECT_FALSE(has_free_ray(cube, std::vector<Vec3>{Vec3(-5, -5, -5)}, std::vector<Vec3>{Vec3(1, 1, 1)}));
  EXPECT_TRUE(has_free_ray(cube, std::vector<Vec3>{Vec3(10.001, 5, 5)}, up));
}

TEST(EdgeFaults, AreCountedAndGatheredByRim) {
  EXPECT_TRUE(find_edge_faults(shapes::torus()).is_empty());
  const EdgeFaults open = find_edge_faults(shapes::open_cube(10));
  EXPECT_EQ(open.open, 4U);
  ASSERT_EQ(open.gaps.size(), 1U);
  EXPECT_NEAR(open.gaps[0].width_mm, 10 / std::sqrt(2.0), 1e-12);
  IndexedMesh turned = shapes::cube(10);
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  const EdgeFaults faults = find_edge_faults(turned);
  EXPECT_EQ(faults.open, 0U);
  EXPECT_EQ(faults.misoriented, 3U);
  for (const FaultyEdge& e : faults.gaps[0].edges) EXPECT_EQ(e.surplus, 2);
}

TEST(EdgeFaults, FilesThatFitTogetherHaveNone) {
  IndexedMesh lower = shapes::cube(10), upper = lower;
  lower.triangles.resize(6);
  upper.triangles.erase(upper.triangles.begin(), upper.triangles.begin() + 6);
  EXPECT_FALSE(find_edge_faults(lower).is_empty());
  EXPECT_TRUE(find_edge_faults(weld_together(std::vector<IndexedMesh>{lower, upper}).mesh).is_empty());
}

}  // namespace
}  // namespace gouge::enclosure_test
