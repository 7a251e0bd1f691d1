#include "lib/mesh/adjacency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/shapes.h"

namespace gouge::adjacency_test {
namespace {

TEST(Adjacency, ACubeHasEighteenEdgesEachWithTwoOppositeUses) {
  const IndexedMesh mesh = shapes::cube();
  const MeshAdjacency adjacency(mesh);
  ASSERT_EQ(adjacency.edges().size(), 18U);
  for (const MeshEdge& edge : adjacency.edges()) {
    ASSERT_EQ(edge.use_count, 2U);
    EXPECT_NE(adjacency.uses(edge)[0].is_forward, adjacency.uses(edge)[1].is_forward);
  }
}

TEST(Adjacency, ClosedSurfacesOfGenusZeroObeyEuler) {
  for (const IndexedMesh& mesh : {shapes::cube(), shapes::tetrahedron(), shapes::sphere(), shapes::needle_fan()}) {
    const MeshAdjacency adjacency(mesh);
    const std::size_t v = mesh.vertices.size();
    EXPECT_EQ(adjacency.edges().size(), 3 * v - 6) << mesh.name;
    EXPECT_EQ(mesh.triangles.size(), 2 * v - 4) << mesh.name;
  }
}

TEST(Adjacency, EdgesOfTrianglesAndTrianglesOfVerticesAgreeWithBruteForce) {
  for (const IndexedMesh& mesh :
       {shapes::sphere(), shapes::cubes_touching_at_edge(), shapes::needle_fan(50), shapes::sheet(1, 1, 0, 7, 5)}) {
    const MeshAdjacency adjacency(mesh);
    std::map<std::pair<Corner, Corner>, std::vector<std::uint32_t>> users;
    std::vector<std::vector<std::uint32_t>> around(mesh.vertices.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner a = mesh.triangles[t][k];
        const Corner b = mesh.triangles[t][(k + 1) % 3];
        users[std::minmax(a, b)].push_back(t);
        around[a].push_back(t);
        const MeshEdge& edge = adjacency.edges()[adjacency.edges_of_triangle(t)[k]];
        EXPECT_EQ(std::pair(edge.low, edge.high), std::pair(std::min(a, b), std::max(a, b)));
      }
    }
    ASSERT_EQ(adjacency.edges().size(), users.size());
    auto expected = users.begin();
    for (const MeshEdge& edge : adjacency.edges()) {
      EXPECT_EQ(std::pair(edge.low, edge.high), expected->first);
      std::vector<std::uint32_t> found;
      for (const EdgeUse& use : adjacency.uses(edge)) found.push_back(use.triangle);
      EXPECT_EQ(found, expected->second);
      ++expected;
    }
    for (Corner v = 0; v < mesh.vertices.size(); ++v) {
      EXPECT_TRUE(std::ranges::equal(adjacency.triangles_of_vertex(v), around[v]));
    }
  }
}

TEST(Adjacency, ABorderHasOneUseAndTwoCubesShareFour) {
  const auto edges_with = [](const IndexedMesh& mesh, std::uint32_t uses) {
    const MeshAdjacency adjacency(mesh);
    return std::ranges::count(adjacency.edges(), uses, &MeshEdge::use_count);
  };
  EXPECT_EQ(edges_with(shapes::open_cube(), 1), 4);
  EXPECT_EQ(edges_with(shapes::cubes_touching_at_edge(), 4), 1);
}

TEST(VertexTriangles, FindTheTrianglesOfAnEdgeFromEitherEnd) {
  for (const IndexedMesh& mesh :
       {shapes::open_cube(), shapes::cubes_touching_at_edge(), shapes::needle_fan(50), shapes::torus()}) {
    const VertexTriangles around(mesh);
    const MeshAdjacency adjacency(mesh);
    for (const MeshEdge& edge : adjacency.edges()) {
      for (const auto& [a, b] : {std::pair(edge.low, edge.high), std::pair(edge.high, edge.low)}) {
        const EdgeTriangles found = around.at_edge(mesh, a, b);
        ASSERT_EQ(found.count, edge.use_count);
        EXPECT_EQ(found.first[0], adjacency.uses(edge)[0].triangle);
        if (edge.use_count > 1) {
          EXPECT_EQ(found.first[1], adjacency.uses(edge)[1].triangle);
        }
      }
    }
  }
}

}  // namespace
}  // namespace gouge::adjacency_test
