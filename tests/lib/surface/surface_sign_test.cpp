#include "lib/surface/surface_sign.h"

#include <gtest/gtest.h>

#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace gouge::surface_sign_test {
namespace {

/// All normals in tables, from a full adjacency.
class Tables {
 public:
  explicit Tables(const IndexedMesh& mesh) : mesh_(mesh), adjacency_(mesh) {
    edges_.resize(adjacency_.edges().size(), Vec3::Zero());
    std::vector<bool> is_doubtful(mesh.vertices.size(), false);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const MeshEdge& edge = adjacency_.edges()[e];
      const auto uses = adjacency_.uses(edge);
      bool is_plain = uses.size() == 2 && uses[0].is_forward != uses[1].is_forward;
      for (const EdgeUse& use : uses) {
        is_plain = is_plain && face_normal(mesh, use.triangle).squaredNorm() > 0;
        edges_[e] += face_normal(mesh, use.triangle);
      }
      if (is_plain) continue;
      edges_[e].setZero();
      is_doubtful[edge.low] = is_doubtful[edge.high] = true;
    }
    for (Corner v = 0; v < mesh.vertices.size(); ++v) {
      Vec3 sum = Vec3::Zero();
      for (const std::uint32_t t : adjacency_.triangles_of_vertex(v))
        sum += angle_at(mesh, t, v) * face_normal(mesh, t);
      const bool has_normal = !is_doubtful[v] && sum.norm() > 1e-12;
      vertices_.push_back(has_normal ? Vec3(sum / sum.norm()) : Vec3(Vec3::Zero()));
    }
  }

  [[nodiscard]] Vec3 at_edge(std::uint32_t t, std::size_t k) const {
    return edges_[adjacency_.edges_of_triangle(t)[k]];
  }
  [[nodiscard]] Vec3 at_corner(std::uint32_t t, std::size_t k) const { return vertices_[mesh_.triangles[t][k]]; }

 private:
  const IndexedMesh& mesh_;
  MeshAdjacency adjacency_;
  std::vector<Vec3> edges_, vertices_;
};

/// With an edge of its box doubled back: a triangle with three corners on one line.
IndexedMesh with_flat_triangle() {
  IndexedMesh mesh = shapes::tetrahedron(10);
  const auto middle = static_cast<Corner>(mesh.vertices.size());
  const TriangleCorners t = mesh.triangles[0];
  mesh.vertices.push_back(0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]));
  mesh.triangles[0] = {middle, t[1], t[2]};
  shapes::add_triangle(mesh, t[0], middle, t[2]);
  shapes::add_triangle(mesh, t[0], t[1], middle);
  return mesh;
}

TEST(SurfaceSign, IsToTheLastBitThatOfTablesOfAllNormals) {
  std::size_t without = 0;
  for (const IndexedMesh& mesh :
       {shapes::cube(), shapes::open_cube(), shapes::needle_fan(), shapes::torus(), shapes::bumpy_sphere(),
        shapes::cubes_touching_at_edge(), shapes::cubes_touching_at_vertex(), shapes::cubes_crossing(),
        shapes::inside_out(shapes::cube()), shapes::joined(shapes::cube(), shapes::cube()), with_flat_triangle()}) {
    const VertexTriangles around(mesh);
    const SurfaceSign sign(mesh, around);
    const Tables tables(mesh);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      EXPECT_EQ(sign.outward(t, TriangleFeature::face, 0), face_normal(mesh, t));
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(sign.outward(t, TriangleFeature::edge, k), tables.at_edge(t, k)) << mesh.name << " " << t;
        EXPECT_EQ(sign.outward(t, TriangleFeature::corner, k), tables.at_corner(t, k)) << mesh.name << " " << t;
        without += tables.at_corner(t, k).squaredNorm() > 0 ? 0U : 1U;
      }
    }
  }
  EXPECT_GT(without, 20U) << "no feature that the theorem does not cover";
}

}  // namespace
}  // namespace gouge::surface_sign_test
