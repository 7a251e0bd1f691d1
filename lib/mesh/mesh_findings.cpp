#include "lib/mesh/mesh_findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "lib/mesh/winding.h"

namespace gouge {
namespace {

// Telling a cavity from an inside-out body costs one pass over the mesh; files with more inward pieces than
// this are broken anyway.
constexpr std::size_t kMostInwardPieces = 64;

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // The lower index becomes the root, so roots do not depend on the order of joining.
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

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
    find_pieces();
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
    for (const std::uint32_t t : duplicates)
      found_.duplicate_triangles.add(centre(t), mesh_.file_triangle[t]);
  }

  [[nodiscard]] Vec3 centre(std::size_t t) const {
    return (mesh_.corner(t, 0) + mesh_.corner(t, 1) + mesh_.corner(t, 2)) / 3;
  }

  void find_pieces() {
    const Vec3 middle = found_.box_mm.center();
    std::vector<double> volume(mesh_.triangles.size(), 0);
    std::vector<bool> is_open(mesh_.triangles.size(), false);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Vec3 a = mesh_.corner(t, 0) - middle;
      const Vec3 b = mesh_.corner(t, 1) - middle;
      const Vec3 c = mesh_.corner(t, 2) - middle;
      const double six = a.dot(b.cross(c));
      volume[pieces_.root(t)] += six / 6;
      found_.signed_volume_mm3 += six / 6;
      found_.area_mm2 += (b - a).cross(c - a).norm() / 2;
      if (pieces_.root(t) == t) ++found_.components;
    }
    for (const MeshEdge& edge : adjacency_.edges()) {
      const auto uses = adjacency_.uses(edge);
      const auto forward =
          std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.is_forward; });
      if (2 * static_cast<std::size_t>(forward) != uses.size())
        is_open[pieces_.root(uses[0].triangle)] = true;
    }
    std::size_t looked_at = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (pieces_.root(t) != t || is_open[t] || volume[t] >= 0) continue;
      if (looked_at++ < kMostInwardPieces && is_cavity(t)) {
        ++found_.cavities;
      } else {
        found_.inside_out_components.add(centre(t), mesh_.file_triangle[t]);
      }
    }
  }

  // A piece that faces inward is a cavity when the other pieces have its surface inside them.
  bool is_cavity(std::uint32_t piece) {
    const Vec3 point = centre(piece);
    double angle = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (pieces_.root(t) != piece)
        angle += solid_angle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), point);
    }
    constexpr double kHalfSphere = 6.283185307179586;
    return angle > kHalfSphere;
  }

  const IndexedMesh& mesh_;
  const MeshAdjacency& adjacency_;
  UnionFind pieces_;
  MeshFindings found_;
};

}  // namespace

std::optional<long long> MeshFindings::handles() const {
  if (!is_closed() || !is_manifold()) return std::nullopt;
  return static_cast<long long>(components) - euler_number() / 2;
}

MeshFindings find_mesh_findings(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  return Finder(mesh, adjacency).find();
}

MeshFindings find_mesh_findings(const IndexedMesh& mesh) {
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
