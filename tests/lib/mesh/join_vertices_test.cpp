#include "lib/mesh/join_vertices.h"

#include <gtest/gtest.h>

#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::join_vertices_test {
namespace {

/// Every triangle with corners of its own, each moved by up to `off` along each axis.
IndexedMesh torn(const IndexedMesh& mesh, double off) {
  test::Scatter random(7);
  IndexedMesh apart;
  apart.name = mesh.name;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) apart.vertices.push_back(mesh.corner(t, k) + random.point(off));
    shapes::add_triangle(apart, 3 * t, 3 * t + 1, 3 * t + 2);
  }
  return apart;
}

TEST(JoinNearVertices, ASeamThatHardlyGapesIsClosed) {
  const IndexedMesh mesh = torn(shapes::sphere(10), 0.001);
  EXPECT_FALSE(find_mesh_findings(mesh).is_closed());
  const Result<JoinedMesh> joined = join_near_vertices(mesh, 0.005);
  ASSERT_TRUE(joined.has_value());
  EXPECT_TRUE(joined->findings.is_solid());
  EXPECT_EQ(joined->mesh.vertices.size(), shapes::sphere(10).vertices.size());
  EXPECT_EQ(joined->vertices_joined, mesh.vertices.size() - joined->mesh.vertices.size());
  EXPECT_GT(joined->largest_shift_mm, 0.001);
  EXPECT_LE(joined->largest_shift_mm, 0.005);
  EXPECT_EQ(joined->triangles_collapsed, 0U);
}

// 101 vertices in a row, 0.006 apart: joined one to the next they would all end in one place, 0.6 away.
TEST(JoinNearVertices, AChainMovesNoVertexFartherThanTheReach) {
  IndexedMesh strip;
  for (int i = 0; i <= 100; ++i) {
    strip.vertices.emplace_back(0.006 * i, 0, 0);
    strip.vertices.emplace_back(0.006 * i, 1, 0);
  }
  for (std::size_t i = 0; i < 100; ++i) shapes::add_quad(strip, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  const Result<JoinedMesh> joined = join_near_vertices(strip, 0.01);
  ASSERT_TRUE(joined.has_value());
  EXPECT_LE(joined->largest_shift_mm, 0.01);
  EXPECT_NEAR(joined->mesh.box().sizes().x(), 0.6, 0.01);
  EXPECT_GT(joined->triangles_collapsed, 0U);
  for (std::size_t i = 0; i < joined->mesh.vertices.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT((joined->mesh.vertices[i] - joined->mesh.vertices[k]).norm(), 0.01);
  }
}

TEST(JoinNearVertices, EachGoesToTheNearestAndTheReachCounts) {
  IndexedMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.3, 0, 0), Vec3(0, 5, 0), Vec3(5, 0, 0)};
  shapes::add_triangle(mesh, 0, 4, 3);
  shapes::add_triangle(mesh, 1, 4, 3);
  shapes::add_triangle(mesh, 2, 4, 3);
  const Result<JoinedMesh> joined = join_near_vertices(mesh, 0.4);
  ASSERT_TRUE(joined.has_value());
  EXPECT_EQ(joined->vertices_joined, 1U);
  EXPECT_DOUBLE_EQ(joined->largest_shift_mm, 0.2);
  EXPECT_EQ(join_near_vertices(mesh, 0.19)->vertices_joined, 0U);
  EXPECT_EQ(join_near_vertices(mesh, 0.5)->vertices_joined, 2U) << "a distance of exactly the reach is near";
}

TEST(JoinNearVertices, TrianglesKeepTheirNumbersInTheFile) {
  IndexedMesh mesh = torn(shapes::cube(10), 0.001);
  for (std::uint32_t& number : mesh.file_triangle) number += 100;
  mesh.vertices[1] = mesh.vertices[0] + Vec3(0, 0, 0.001);  // the first collapses
  const Result<JoinedMesh> joined = join_near_vertices(mesh, 0.01);
  ASSERT_TRUE(joined.has_value());
  EXPECT_EQ(joined->triangles_collapsed, 1U);
  EXPECT_EQ(joined->findings.degenerate_triangles.file_triangle, 100U);
  EXPECT_EQ(joined->mesh.file_triangle.front(), 101U);
}

TEST(JoinNearVertices, WhatCollapsesWhollyIsRefused) {
  const Result<JoinedMesh> joined = join_near_vertices(shapes::cube(10), 50);
  ASSERT_FALSE(joined.has_value());
  EXPECT_EQ(joined.error().code, "mesh-weld");
}

}  // namespace
}  // namespace gouge::join_vertices_test
