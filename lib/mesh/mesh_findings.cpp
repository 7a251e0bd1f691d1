#include "lib/mesh/mesh_findings.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "lib/mesh/mesh_pieces.h"
#include "lib/mesh/opposite_half_edges.h"

namespace gouge {
namespace {

class Finder {
 public:
  Finder(const IndexedMesh& mesh, const MeshAdjacency& adjacency)
      : mesh_(mesh), adjacency_(adjacency), pieces_(mesh.triangles.size()) {}

  MeshFindings find() {
    found_.vertices = mesh_.vertices.size();
    found_.edges = adjacency_.edges().size();
    found_.triangles = mesh_.triangles.size();
    found_.box_mm = mesh_.box();
    find_edges();
    find_vertices();
    find_duplicates();
    find_open_pieces();
    detail::find_pieces(mesh_, pieces_, is_open_, found_);
    return found_;
  }

 private:
  void find_edges() {
    for (const MeshEdge& edge : adjacency_.edges()) {
      const auto uses = adjacency_.uses(edge);
      const auto forward = static_cast<std::size_t>(
          std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.is_forward; }));
      const Vec3 middle = (mesh_.vertices[edge.low] + mesh_.vertices[edge.high]) / 2;
      const std::size_t triangle = mesh_.file_triangle[uses[0].triangle];
      if (uses.size() == 1) found_.boundary_edges.add(middle, triangle);
      if (uses.size() > 2) found_.non_manifold_edges.add(middle, triangle);
      if (uses.size() == 2 && forward != 1) found_.misoriented_edges.add(middle, triangle);
      if (2 * forward != uses.size()) found_.unbalanced_edges.add(middle, triangle);
      for (const EdgeUse& use : uses) pieces_.join(uses[0].triangle, use.triangle);
    }
  }

  // Corners at one vertex belong to one fan when a chain of edges at that vertex joins their triangles.
  void find_vertices() {
    UnionFind fans(3 * mesh_.triangles.size());
    for (const MeshEdge& edge : adjacency_.edges()) {
      const auto uses = adjacency_.uses(edge);
      for (const EdgeUse& use : uses.subspan(1)) {
        fans.join(corner_at(uses[0].triangle, edge.low), corner_at(use.triangle, edge.low));
        fans.join(corner_at(uses[0].triangle, edge.high), corner_at(use.triangle, edge.high));
      }
    }
    for (Corner v = 0; v < mesh_.vertices.size(); ++v) {
      const auto around = adjacency_.triangles_of_vertex(v);
      for (std::size_t i = 1; i < around.size(); ++i) {
        if (fans.root(corner_at(around[i], v)) == fans.root(corner_at(around[0], v))) continue;
        found_.non_manifold_vertices.add(mesh_.vertices[v], mesh_.file_triangle[around[i]]);
        break;
      }
    }
  }

  [[nodiscard]] std::uint32_t corner_at(std::uint32_t triangle, Corner vertex) const {
    const TriangleCorners& t = mesh_.triangles[triangle];
    return 3 * triangle + (t[0] == vertex ? 0U : t[1] == vertex ? 1U : 2U);
  }

  // Copies of a triangle share its edge of the two lowest vertices, so only triangles around one edge are
  // compared.
  void find_duplicates() {
    std::vector<std::uint32_t> duplicates;
    std::vector<std::pair<Corner, std::uint32_t>> at_edge;
    for (const MeshEdge& edge : adjacency_.edges()) {
      if (edge.use_count < 2) continue;
      at_edge.clear();
      for (const EdgeUse& use : adjacency_.uses(edge)) {
        const TriangleCorners& t = mesh_.triangles[use.triangle];
        const Corner highest = std::max({t[0], t[1], t[2]});
        if (highest != edge.high) at_edge.emplace_back(highest, use.triangle);
      }
      std::sort(at_edge.begin(), at_edge.end());
      for (std::size_t i = 1; i < at_edge.size(); ++i) {
        if (at_edge[i].first == at_edge[i - 1].first) duplicates.push_back(at_edge[i].second);
      }
    }
    std::sort(duplicates.begin(), duplicates.end());
    for (const std::uint32_t t : duplicates) found_.duplicate_triangles.add(centre(t), mesh_.file_triangle[t]);
  }

  [[nodiscard]] Vec3 centre(std::size_t t) const {
    return (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2)) / 3;
  }

  void find_open_pieces() {
    is_open_.assign(mesh_.triangles.size(), false);
    for (const MeshEdge& edge : adjacency_.edges()) {
      const auto uses = adjacency_.uses(edge);
      const auto forward = std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.is_forward; });
      if (2 * static_cast<std::size_t>(forward) != uses.size()) is_open_[pieces_.root(uses[0].triangle)] = true;
    }
  }

  const IndexedMesh& mesh_;
  const MeshAdjacency& adjacency_;
  UnionFind pieces_;
  std::vector<bool> is_open_;  // by the lowest triangle of a piece
  MeshFindings found_;
};

// Where each edge has two triangles and each vertex one fan, all there is to find is about whole pieces.
MeshFindings find_closed_findings(const IndexedMesh& mesh, const OppositeHalfEdges& opposites) {
  MeshFindings found;
  found.vertices = mesh.vertices.size();
  found.edges = opposites.size() / 2;
  found.triangles = mesh.triangles.size();
  found.box_mm = mesh.box();
  UnionFind pieces(mesh.triangles.size());
  for (std::uint32_t side = 0; side < opposites.size(); ++side) {
    if (opposites[side] < side) pieces.join(opposites[side] / 3, side / 3);
  }
  detail::find_pieces(mesh, pieces, {}, found);
  return found;
}

}  // namespace

std::optional<long long> MeshFindings::handles() const {
  if (!is_closed() || !is_manifold()) return std::nullopt;
  return static_cast<long long>(components) - euler_number() / 2;
}

MeshFindings find_mesh_findings(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  return Finder(mesh, adjacency).find();
}

MeshFindings find_mesh_findings(const IndexedMesh& mesh) {
  if (const auto opposites = find_opposite_half_edges(mesh); opposites && is_manifold(mesh, *opposites)) {
    return find_closed_findings(mesh, *opposites);
  }
  return find_mesh_findings(mesh, MeshAdjacency(mesh));
}

MeshFindings find_mesh_findings(const BuiltMesh& built) {
  MeshFindings found = find_mesh_findings(built.mesh);
  found.degenerate_triangles = built.degenerate;
  found.collinear_triangles = built.collinear;
  found.opposite_normals = built.opposite_normals;
  return found;
}

}  // namespace gouge
