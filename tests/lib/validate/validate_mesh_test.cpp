#include "lib/validate/validate_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace gouge::validate_mesh_test {
namespace {

MeshValidation judge(const IndexedMesh& mesh) { return validate_mesh(mesh, find_mesh_findings(mesh)); }

TEST(ValidateMesh, ClosedOutwardMeshesAreSound) {
  for (const IndexedMesh& mesh : {shapes::cube(), shapes::tetrahedron(), shapes::sphere(), shapes::torus(),
                                  shapes::needle_fan(), shapes::hollow_cube()}) {
    const MeshValidation judged = judge(mesh);
    EXPECT_TRUE(judged.is_sound()) << mesh.name << " " << judged.trouble;
    EXPECT_EQ(judged.defects(), 0U) << mesh.name;
    EXPECT_NEAR(judged.volume_mm3.value_or(0), judged.findings.signed_volume_mm3,
                1e-9 * judged.findings.signed_volume_mm3);
  }
}

TEST(ValidateMesh, AnOpenMeshIsNotSoundAndHasNoVolume) {
  const MeshValidation judged = judge(shapes::open_cube());
  EXPECT_FALSE(judged.is_sound());
  EXPECT_EQ(judged.bounds_volume, std::nullopt);
  EXPECT_EQ(judged.volume_mm3, std::nullopt);
  EXPECT_EQ(judged.defects(), 4U);
}

TEST(ValidateMesh, InsideOutIsNotSound) {
  const MeshValidation judged = judge(shapes::inside_out(shapes::cube()));
  EXPECT_FALSE(judged.is_sound());
  EXPECT_EQ(judged.bounds_volume, false);
  EXPECT_LT(judged.volume_mm3.value_or(0), 0);
}

TEST(ValidateMesh, ASolidInsideASolidBoundsNoVolume) {
  const IndexedMesh nested = shapes::joined(shapes::cube(10), shapes::box(Vec3::Constant(3), Vec3::Constant(6)));
  const MeshValidation judged = judge(nested);
  EXPECT_EQ(judged.self_intersections.pairs, 0U);
  EXPECT_EQ(judged.bounds_volume, false);
  EXPECT_FALSE(judged.is_sound());
}

TEST(ValidateMesh, CrossingCubesAreFoundWithAPlaceOnBothSurfaces) {
  const MeshValidation judged = judge(shapes::cubes_crossing(10));
  EXPECT_FALSE(judged.is_sound());
  EXPECT_GT(judged.self_intersections.pairs, 0U);
  EXPECT_LT(judged.self_intersections.first_triangle, 12U);
  EXPECT_GE(judged.self_intersections.second_triangle, 12U);
  const Vec3 place = judged.self_intersections.position_mm;
  const auto is_on_cube = [&](double low, double high) {
    const Vec3 to_faces = (place.array() - low).abs().min((place.array() - high).abs());
    return to_faces.minCoeff() < 1e-9 && place.minCoeff() > low - 1e-9 && place.maxCoeff() < high + 1e-9;
  };
  EXPECT_TRUE(is_on_cube(0, 10)) << place.transpose();
  EXPECT_TRUE(is_on_cube(5, 15)) << place.transpose();
}

TEST(ValidateMesh, AFoldOfTwoTrianglesOntoEachOtherIsASelfIntersection) {
  IndexedMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0), Vec3(2, 3, 0), Vec3(2, -3, 0), Vec3(2, 3, 1e-9)};
  shapes::add_triangle(mesh, 0, 1, 2);
  shapes::add_triangle(mesh, 1, 0, 3);
  EXPECT_EQ(judge(mesh).self_intersections.pairs, 1U);
  mesh.triangles[1] = {1, 0, 4};  // on the other side of the shared edge
  EXPECT_EQ(judge(mesh).self_intersections.pairs, 0U);
  mesh.triangles[1] = {1, 0, 5};  // a nanometre is enough: the test is exact
  EXPECT_EQ(judge(mesh).self_intersections.pairs, 0U);
}

TEST(ValidateMesh, ATriangleThroughItsNeighbourAtACornerIsASelfIntersection) {
  IndexedMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0),  Vec3(0, 10, 0),  Vec3(4, 4, -1),
                   Vec3(4, 4, 1), Vec3(-4, -4, 1), Vec3(-4, -4, -1)};
  shapes::add_triangle(mesh, 0, 1, 2);
  shapes::add_triangle(mesh, 0, 3, 4);
  const MeshValidation judged = judge(mesh);
  EXPECT_EQ(judged.self_intersections.pairs, 1U);
  EXPECT_TRUE(judged.self_intersections.position_mm.isApprox(Vec3(4, 4, 0)))
      << judged.self_intersections.position_mm.transpose();
  mesh.triangles[1] = {0, 5, 6};
  EXPECT_EQ(judge(mesh).self_intersections.pairs, 0U);
}

TEST(ValidateMesh, TouchingCubesAreNotManifold) {
  EXPECT_FALSE(judge(shapes::cubes_touching_at_edge()).is_sound());
  EXPECT_FALSE(judge(shapes::cubes_touching_at_vertex()).is_sound());
}

TEST(ValidateMesh, DuplicatesAndTrianglesWithoutAreaAreNoSelfIntersections) {
  IndexedMesh mesh = shapes::sheet(10, 10, 0);
  mesh.vertices.emplace_back(5, 5, 0);
  shapes::add_triangle(mesh, 2, 0, 1);  // copy of a triangle? no: another diagonal, lies on both
  mesh.triangles[2] = mesh.triangles[0];
  shapes::add_triangle(mesh, 0, 4, 3);  // a line along the diagonal
  const MeshValidation judged = judge(mesh);
  EXPECT_EQ(judged.self_intersections.pairs, 0U);
  EXPECT_EQ(judged.findings.duplicate_triangles.count, 1U);
}

TEST(ValidateMesh, OddMeshesAreJudgedWithoutAborting) {
  EXPECT_FALSE(judge(IndexedMesh{}).is_sound());
  IndexedMesh line;
  line.vertices = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
  shapes::add_triangle(line, 0, 1, 2);
  shapes::add_triangle(line, 2, 1, 0);
  EXPECT_FALSE(judge(line).is_sound());
  EXPECT_FALSE(judge(shapes::moved(shapes::open_cube(1e9), Vec3::Constant(-1e9))).is_sound());
}

}  // namespace
}  // namespace gouge::validate_mesh_test
