#include "lib/mesh/mesh_builder.h"

#include <gtest/gtest.h>

#include "lib/mesh/read_stl.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

namespace gouge::mesh_builder_test {
namespace {

TriangleSoup soup_of(std::vector<std::array<Vec3, 3>> triangles) {
  TriangleSoup soup;
  soup.name = "part.stl";
  soup.triangles = std::move(triangles);
  return soup;
}

TriangleSoup soup_of(const IndexedMesh& mesh) {
  TriangleSoup soup;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    soup.triangles.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  }
  return soup;
}

TEST(MeshBuilder, IdenticalCornersBecomeOneVertexInOrderOfAppearance) {
  const auto built = build_mesh(
      soup_of({{Vec3(5, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(0, 0, 1)}}));
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->mesh.vertices, (std::vector<Vec3>{Vec3(5, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}));
  EXPECT_EQ(built->mesh.triangles, (std::vector<TriangleCorners>{{0, 1, 2}, {1, 0, 3}}));
}

TEST(MeshBuilder, NearCornersStayApartAndTheTwoZerosAreOne) {
  const auto built = build_mesh(soup_of(
      {{Vec3(-0.0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, -0.0), Vec3(1, 0, 0), Vec3(1e-300, 1, 0)}}));
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->mesh.vertices.size(), 4U);
  EXPECT_FALSE(std::signbit(built->mesh.vertices[0].x()));
}

TEST(MeshBuilder, TrianglesWithIdenticalCornersAreLeftOutAndLeaveGaps) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0);
  const Vec3 lonely(7, 7, 7);
  const auto built = build_mesh(soup_of({{a, b, a}, {a, b, Vec3(0, 1, 0)}, {lonely, lonely, lonely}}));
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->mesh.file_triangle, std::vector<std::uint32_t>{1});
  EXPECT_EQ(built->mesh.vertices.size(), 3U) << "a vertex of dropped triangles only is no vertex";
  EXPECT_EQ(built->degenerate.count, 2U);
  EXPECT_EQ(built->degenerate.file_triangle, 0U);
  EXPECT_EQ(built->collinear.count, 0U);
}

TEST(MeshBuilder, CollinearTrianglesAreKeptAndCounted) {
  const auto built = build_mesh(soup_of({{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)}}), {LengthUnit::inch, {}});
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->mesh.triangles.size(), 1U);
  EXPECT_EQ(built->collinear.count, 1U);
}

TEST(MeshBuilder, DuplicatedTrianglesStay) {
  const std::array<Vec3, 3> t = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(build_mesh(soup_of({t, t, t}))->mesh.triangles.size(), 3U);
}

TEST(MeshBuilder, ScalesToMillimetresBeforePlacing) {
  MeshPlacement placement;
  placement.unit = LengthUnit::inch;
  placement.transform.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  placement.transform.shift = Vec3(100, 0, 0);
  const auto built = build_mesh(soup_of({{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}}), placement);
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->mesh.vertices, (std::vector<Vec3>{Vec3(100, 25.4, 0), Vec3(74.6, 0, 0), Vec3(100, 0, 25.4)}));
}

TEST(MeshBuilder, ASoupOfASphereHasTheSphereAgain) {
  const IndexedMesh sphere = shapes::sphere(10, 40, 80);
  const auto built = build_mesh(soup_of(sphere));
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(built->mesh.vertices.size(), sphere.vertices.size());
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(built->mesh.corner(t, k), sphere.corner(t, k));
  }
}

TEST(MeshBuilder, NothingButDegenerateTrianglesIsAnError) {
  const auto built = build_mesh(soup_of({{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)}}));
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(to_text(built.error()),
            "part.stl: error: every triangle of 1 has two identical corners; expected a surface [stl-no-surface]");
}

TEST(MeshBuilder, CoordinatesOfAPlanetAreAnError) {
  const auto built = build_mesh(soup_of({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1e8, 0)}}), {LengthUnit::inch, {}});
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(to_text(built.error()),
            "part.stl: error: triangle 1 has a coordinate beyond 1e9 mm; expected a machine part, check the file and "
            "its unit [stl-coordinate-too-large]");
}

}  // namespace
}  // namespace gouge::mesh_builder_test
