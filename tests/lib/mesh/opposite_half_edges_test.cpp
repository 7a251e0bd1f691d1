#include "lib/mesh/opposite_half_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lib/mesh/mesh_findings.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::opposite_half_edges_test {
namespace {

std::string text(const MeshSpot& spot) {
  if (spot.count == 0) return "0 ";
  return std::to_string(spot.count) + "@" + std::to_string(spot.file_triangle) + "(" +
         std::to_string(spot.position_mm.x()) + "," + std::to_string(spot.position_mm.y()) + "," +
         std::to_string(spot.position_mm.z()) + ") ";
}

std::string text(const MeshFindings& found) {
  std::string all = std::to_string(found.vertices) + " " + std::to_string(found.edges) + " " +
                    std::to_string(found.triangles) + " " + std::to_string(found.components) + " " +
                    std::to_string(found.cavities) + ": ";
  for (const MeshSpot* spot :
       {&found.boundary_edges, &found.non_manifold_edges, &found.misoriented_edges, &found.unbalanced_edges,
        &found.non_manifold_vertices, &found.duplicate_triangles, &found.inside_out_components}) {
    all += text(*spot);
  }
  return all;
}

/// Some shapes beside and over each other, their triangles in any order.
IndexedMesh random_scene(test::Scatter& random) {
  const std::vector<IndexedMesh> shapes = {shapes::cube(),       shapes::tetrahedron(),
                                           shapes::torus(),      shapes::hollow_cube(),
                                           shapes::sphere(),     shapes::inside_out(shapes::cube(3)),
                                           shapes::needle_fan(), shapes::cubes_touching_at_edge(),
                                           shapes::open_cube(),  shapes::cubes_touching_at_vertex()};
  IndexedMesh mesh = shapes[random.next() % 6];
  for (auto k = random.next() % 3; k > 0; --k) {
    // Mostly the closed ones, so that both ways are gone often.
    const IndexedMesh& more = shapes[random.next() % 8 == 0 ? random.next() % shapes.size() : random.next() % 6];
    mesh = shapes::joined(mesh, shapes::moved(more, Vec3(static_cast<double>(random.next() % 3) * 40, 0, 0)));
  }
  random.shuffle(mesh.triangles);
  for (TriangleCorners& t : mesh.triangles) std::rotate(t.begin(), t.begin() + random.next() % 3, t.end());
  return mesh;
}

/// One fault of the kinds that files have.
void break_something(IndexedMesh& mesh, test::Scatter& random) {
  const std::size_t t = random.next() % mesh.triangles.size();
  const TriangleCorners corners = mesh.triangles[t];
  switch (random.next() % 5) {
    case 0:
      std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
      break;
    case 1:
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      break;
    case 2:
      shapes::add_triangle(mesh, corners[1], corners[2], corners[0]);
      break;
    case 3:
      shapes::add_triangle(mesh, corners[1], corners[0], corners[2]);
      break;
    default: {  // two vertices become one
      const Corner to = corners[0], from = mesh.triangles[random.next() % mesh.triangles.size()][0];
      for (TriangleCorners& c : mesh.triangles) std::replace(c.begin(), c.end(), from, to);
      std::erase_if(mesh.triangles,
                    [](const TriangleCorners& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; });
    }
  }
  mesh.file_triangle.resize(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.file_triangle.size(); ++i) mesh.file_triangle[i] = i;
}

TEST(OppositeHalfEdges, TheShortWayFindsWhatTheLongOneFinds) {
  test::Scatter random(5);
  std::size_t short_ways = 0, long_ways = 0;
  for (int round = 0; round < 3000; ++round) {
    IndexedMesh mesh = random_scene(random);
    for (auto k = random.next() % 3; k > 0 && mesh.triangles.size() > 1; --k) break_something(mesh, random);
    const MeshFindings found = find_mesh_findings(mesh);
    const MeshFindings all = find_mesh_findings(mesh, MeshAdjacency(mesh));
    ASSERT_EQ(text(found), text(all)) << round;
    ASSERT_EQ(found.signed_volume_mm3, all.signed_volume_mm3);
    ASSERT_EQ(found.area_mm2, all.area_mm2);
    const auto opposites = find_opposite_half_edges(mesh);
    ASSERT_EQ(opposites.has_value(), all.is_closed() && all.is_watertight() && all.non_manifold_edges.count == 0)
        << round;
    const bool is_short = opposites && is_manifold(mesh, *opposites);
    ASSERT_EQ(is_short, opposites && all.non_manifold_vertices.count == 0 && all.duplicate_triangles.count == 0)
        << round;
    ++(is_short ? short_ways : long_ways);
  }
  EXPECT_GT(short_ways, 500U);
  EXPECT_GT(long_ways, 500U);
}

TEST(OppositeHalfEdges, TheTwinOfATwinIsTheSideAndRunsBackAlongTheSameEdge) {
  const IndexedMesh mesh = shapes::torus();
  const auto opposites = find_opposite_half_edges(mesh);
  ASSERT_TRUE(opposites.has_value());
  const auto from = [&](std::uint32_t side) { return mesh.triangles[side / 3][side % 3]; };
  const auto to = [&](std::uint32_t side) { return mesh.triangles[side / 3][(side + 1) % 3]; };
  for (std::uint32_t side = 0; side < opposites->size(); ++side) {
    const std::uint32_t opposite = (*opposites)[side];
    EXPECT_EQ((*opposites)[opposite], side);
    EXPECT_EQ(from(opposite), to(side));
    EXPECT_EQ(to(opposite), from(side));
  }
}

TEST(OppositeHalfEdges, FourTrianglesAtAnEdgeHaveNone) {
  EXPECT_FALSE(find_opposite_half_edges(shapes::cubes_touching_at_edge()).has_value());
  EXPECT_FALSE(find_opposite_half_edges(shapes::open_cube()).has_value());
}

}  // namespace
}  // namespace gouge::opposite_half_edges_test
