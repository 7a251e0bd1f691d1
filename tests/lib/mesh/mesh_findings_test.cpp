#include "lib/mesh/mesh_findings.h"

#include <gtest/gtest.h>

#include "lib/mesh/load_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

namespace gouge::mesh_findings_test {
namespace {

TEST(MeshFindings, ACubeIsASolid) {
  const MeshFindings found = find_mesh_findings(shapes::cube(10));
  EXPECT_TRUE(found.is_closed());
  EXPECT_TRUE(found.is_manifold());
  EXPECT_TRUE(found.is_consistently_oriented());
  EXPECT_TRUE(found.is_solid());
  EXPECT_EQ(found.components, 1U);
  EXPECT_NEAR(found.signed_volume_mm3, 1000, 1e-9);
  EXPECT_NEAR(found.area_mm2, 600, 1e-9);
  EXPECT_EQ(found.euler_number(), 2);
  EXPECT_EQ(found.handles(), 0);
  EXPECT_TRUE(describe(found, "part.stl").empty());
}

TEST(MeshFindings, HandlesAreCounted) {
  EXPECT_EQ(find_mesh_findings(shapes::torus()).handles(), 1);
  EXPECT_EQ(
      find_mesh_findings(shapes::joined(shapes::torus(), shapes::moved(shapes::cube(), Vec3(99, 0, 0)))).handles(), 1);
  EXPECT_EQ(find_mesh_findings(shapes::open_cube()).handles(), std::nullopt);
}

TEST(MeshFindings, VolumeFarFromTheOriginIsStillRight) {
  const IndexedMesh far = shapes::moved(shapes::cube(10), Vec3(1e6, -2e6, 3e6));
  EXPECT_NEAR(find_mesh_findings(far).signed_volume_mm3, 1000, 1e-6);
}

TEST(MeshFindings, AnOpenCubeCannotTellBuried) {
  const MeshFindings found = find_mesh_findings(shapes::open_cube(10));
  EXPECT_FALSE(found.is_closed());
  EXPECT_FALSE(found.is_solid());
  EXPECT_EQ(found.boundary_edges.count, 4U);
  EXPECT_EQ(found.inside_out_components.count, 0U);
  const Diagnostics reported = describe(found, "part.stl");
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(to_text(reported[0]),
            "part.stl: warning: 4 open edges (one triangle only), the first at (5.000, 0.000, 10.000) mm, triangle 4; "
            "the surface is checked, but a move that only this body could prove to be outside or inside is not "
            "certified: export a closed solid [mesh-open]");
}

TEST(MeshFindings, OneTurnedTriangleHasThreeMisorientedEdges) {
  IndexedMesh mesh = shapes::cube();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const MeshFindings found = find_mesh_findings(mesh);
  EXPECT_TRUE(found.is_closed());
  EXPECT_EQ(found.misoriented_edges.count, 3U);
  EXPECT_FALSE(found.is_watertight());
  EXPECT_EQ(describe(found, "").at(0).code, "mesh-misoriented");
}

TEST(MeshFindings, InsideOutIsDistinguishedFromACavity) {
  const MeshFindings inverted = find_mesh_findings(shapes::inside_out(shapes::cube(10)));
  EXPECT_EQ(inverted.inside_out_components.count, 1U);
  EXPECT_NEAR(inverted.signed_volume_mm3, -1000, 1e-9);
  EXPECT_FALSE(inverted.is_solid());
  EXPECT_EQ(describe(inverted, "part.stl").at(0).code, "mesh-inside-out");

  const MeshFindings hollow = find_mesh_findings(shapes::hollow_cube(10));
  EXPECT_EQ(hollow.inside_out_components.count, 0U);
  EXPECT_EQ(hollow.cavities, 1U);
  EXPECT_EQ(hollow.components, 2U);
  EXPECT_TRUE(hollow.is_solid());
  EXPECT_NEAR(hollow.signed_volume_mm3, 875, 1e-9);
}

TEST(MeshFindings, OneOfTwoBodiesInsideOutIsFound) {
  const IndexedMesh pair =
      shapes::joined(shapes::cube(), shapes::moved(shapes::inside_out(shapes::cube()), Vec3(50, 0, 0)));
  const MeshFindings found = find_mesh_findings(pair);
  EXPECT_EQ(found.inside_out_components.count, 1U);
  EXPECT_EQ(found.inside_out_components.file_triangle, 12U);
}

TEST(MeshFindings, CubesTouchingAtAnEdgeAreASolidButNotManifold) {
  const MeshFindings found = find_mesh_findings(shapes::cubes_touching_at_edge(10));
  EXPECT_EQ(found.non_manifold_edges.count, 1U);
  EXPECT_EQ(found.non_manifold_edges.position_mm, Vec3(10, 10, 5));
  EXPECT_TRUE(found.is_solid());
  const Diagnostics reported = describe(found, "part.stl", LengthUnit::inch);
  EXPECT_EQ(to_text(reported.at(0)),
            "part.stl: note: 1 edge with more than two triangles at (0.3937, 0.3937, 0.1969) in, triangle 5; the check "
            "is not affected [mesh-non-manifold-edges]");
}

TEST(MeshFindings, CubesTouchingAtAVertexHaveANonManifoldVertex) {
  const MeshFindings found = find_mesh_findings(shapes::cubes_touching_at_vertex(10));
  EXPECT_EQ(found.non_manifold_vertices.count, 1U);
  EXPECT_EQ(found.non_manifold_vertices.position_mm, Vec3(10, 10, 10));
  EXPECT_EQ(found.non_manifold_edges.count, 0U);
  EXPECT_EQ(found.components, 2U);
}

TEST(MeshFindings, DuplicatesCountInAnyOrderOfTheirCorners) {
  IndexedMesh mesh = shapes::cube();
  const auto [a, b, c] = mesh.triangles[3];
  shapes::add_triangle(mesh, b, c, a);
  shapes::add_triangle(mesh, c, b, a);
  const MeshFindings found = find_mesh_findings(mesh);
  EXPECT_EQ(found.duplicate_triangles.count, 2U);
  EXPECT_EQ(found.duplicate_triangles.file_triangle, 12U);
  EXPECT_EQ(found.non_manifold_edges.count, 3U);
}

TEST(MeshFindings, ALoneTriangleAndItsTurnedCopyAreDuplicatesWithVolumeZero) {
  IndexedMesh mesh = shapes::tetrahedron();
  mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  mesh.file_triangle = {0, 1};
  const MeshFindings found = find_mesh_findings(mesh);
  EXPECT_EQ(found.duplicate_triangles.count, 1U);
  EXPECT_TRUE(found.is_watertight());
}

TEST(MeshFindings, WhatTheBuilderCountedIsReported) {
  std::string text = shapes::ascii_stl(shapes::cube());
  text.insert(text.find("endsolid"),
              "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 0 vertex 10 0 0 endloop endfacet\n");
  const auto loaded = load_mesh_bytes(text, "part.stl");
  ASSERT_TRUE(loaded.has_value());
  EXPECT_TRUE(loaded->findings.is_solid());
  ASSERT_EQ(loaded->notes.size(), 1U);
  EXPECT_EQ(to_text(loaded->notes[0]),
            "part.stl: note: 1 triangle with identical corners left out at (3.333, 0.000, 0.000) mm, triangle 13; they "
            "have no area [mesh-degenerate-triangles]");
}

TEST(MeshFindings, ThousandInwardPiecesAreCountedQuickly) {
  IndexedMesh mesh;
  for (int i = 0; i < 1000; ++i) {
    const IndexedMesh piece = shapes::moved(shapes::inside_out(shapes::tetrahedron(1)), Vec3(3 * i, 0, 0));
    const std::size_t first = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.end(), piece.vertices.begin(), piece.vertices.end());
    for (const TriangleCorners& t : piece.triangles) {
      shapes::add_triangle(mesh, first + t[0], first + t[1], first + t[2]);
    }
  }
  EXPECT_EQ(find_mesh_findings(mesh).inside_out_components.count, 1000U);
}

TEST(MeshFindings, LoadingNamesTheFileThatIsMissing) {
  const auto loaded = load_mesh("/no/such/part.stl");
  ASSERT_FALSE(loaded.has_value());
  EXPECT_EQ(to_text(loaded.error()),
            "/no/such/part.stl: error: no such file; the folder /no/such does not exist [file-not-found]");
}

}  // namespace
}  // namespace gouge::mesh_findings_test
