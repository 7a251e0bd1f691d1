#include "lib/mesh/mesh_findings.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "lib/base/stage.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/union_find.h"

namespace gouge {
namespace {

// Maximum number of inward pieces that are tested. The distinction between a cavity and an inside-out body costs one
// pass over the mesh; files with more inward pieces than this are broken anyway.
constexpr std::size_t kMaxInwardPieces = 64;

// Units of work for each triangle of a closed mesh: matching edges (3), fans, joining and measuring pieces.
constexpr std::size_t kWorkPerTriangle = 6;
// Units of work for each triangle of any mesh: its edges (2), faults of edges, vertices, copies, pieces.
constexpr std::size_t kStepsOfFaultFinder = 6;

struct Piece {
  std::uint32_t lowest = 0;  // its lowest triangle
  double volume_mm3 = 0;
};

Vec3 centre(const IndexedMesh& mesh, std::size_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

// Returns whether a piece that faces inward is a cavity: its surface is inside the other pieces.
bool is_cavity(const IndexedMesh& mesh, UnionFind& pieces, std::uint32_t piece) {
  const Vec3 point = centre(mesh, piece);
  double angle = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (pieces.root(t) != piece) angle += solid_angle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), point);
  }
  constexpr double kHalfSphere = 6.283185307179586;
  return angle > kHalfSphere;
}

/// Returns the measured pieces in the order of their lowest triangles.
std::vector<Piece> measure_pieces(const IndexedMesh& mesh, UnionFind& roots, MeshFindings& found) {
  const Vec3 middle = found.box_mm.center();
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> number(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = roots.root(t);
    if (root == t) {
      number[t] = static_cast<std::uint32_t>(pieces.size());
      pieces.push_back({t, 0});
    }
    const Vec3 a = mesh.corner(t, 0) - middle;
    const Vec3 b = mesh.corner(t, 1) - middle;
    const Vec3 c = mesh.corner(t, 2) - middle;
    const double six = a.dot(b.cross(c));
    pieces[number[root]].volume_mm3 += six / 6;
    found.signed_volume_mm3 += six / 6;
    found.area_mm2 += (b - a).cross(c - a).norm() / 2;
  }
  return pieces;
}

/// Adds to `found` the facts about pieces of surface: their number, volume and area, cavities and inside-out pieces.
/// `pieces` joins the triangles of a piece. `is_open` is indexed by a piece's lowest triangle; it states that some edge
/// is not used equally often in both directions. It may be empty if there is no such piece. Requires found.box_mm. The
/// cost is stated at find_mesh_findings.
void find_pieces(const IndexedMesh& mesh, UnionFind& pieces, const std::vector<bool>& is_open, MeshFindings& found) {
  std::size_t looked_at = 0;
  const std::vector<Piece> measured = measure_pieces(mesh, pieces, found);
  found.components = measured.size();
  for (const Piece& piece : measured) {
    if (piece.volume_mm3 >= 0 || (!is_open.empty() && is_open[piece.lowest])) continue;
    if (looked_at++ < kMaxInwardPieces && is_cavity(mesh, pieces, piece.lowest)) {
      ++found.cavities;
    } else {
      found.inside_out_components.add(centre(mesh, piece.lowest), mesh.file_triangle[piece.lowest]);
    }
  }
}

class FaultFinder {
 public:
  FaultFinder(const IndexedMesh& mesh, const MeshAdjacency& adjacency)
      : mesh_(mesh), adjacency_(adjacency), pieces_(mesh.triangles.size()) {}

  MeshFindings find(Stage* stage) {
    const auto step = [&] {
      if (stage != nullptr) stage->add(mesh_.triangles.size());
    };
    found_.vertices = mesh_.vertices.size();
    found_.edges = adjacency_.edges().size();
    found_.triangles = mesh_.triangles.size();
    found_.box_mm = mesh_.box();
    find_edges();
    step();
    find_vertices();
    step();
    find_duplicates();
    step();
    find_open_pieces();
    find_pieces(mesh_, pieces_, is_open_, found_);
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

  // Finds vertices between separate fans. Corners at one vertex belong to one fan if a chain of edges at that vertex
  // joins their triangles.
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

  // Finds copies of triangles. Copies share the edge of the two lowest vertices, so only triangles around one edge are
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
  std::vector<bool> is_open_;  // indexed by the lowest triangle of a piece
  MeshFindings found_;
};

// Returns the findings of a mesh in which each edge has two triangles and each vertex one fan. Then only whole pieces
// can be faulty.
MeshFindings find_closed_findings(const IndexedMesh& mesh, const OppositeHalfEdges& opposites, Stage& stage) {
  MeshFindings found;
  found.vertices = mesh.vertices.size();
  found.edges = opposites.size() / 2;
  found.triangles = mesh.triangles.size();
  found.box_mm = mesh.box();
  UnionFind pieces(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    stage.pass(t);
    for (const std::uint32_t side : {3 * t, 3 * t + 1, 3 * t + 2}) {
      if (opposites[side] < side) pieces.join(opposites[side] / 3, t);
    }
  }
  find_pieces(mesh, pieces, {}, found);
  return found;
}

}  // namespace

std::optional<long long> MeshFindings::handles() const {
  if (!is_closed() || !is_manifold()) return std::nullopt;
  return static_cast<long long>(components) - euler_number() / 2;
}

MeshFindings find_mesh_findings(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  return FaultFinder(mesh, adjacency).find(nullptr);
}

MeshFindings find_mesh_findings(const IndexedMesh& mesh, const ProgressCall& progress) {
  const std::size_t count = mesh.triangles.size();
  Stage stage(progress, "looking for faults of " + mesh.name, count, kWorkPerTriangle * count);
  if (const auto opposites = find_opposite_half_edges(mesh, &stage);
      opposites && is_manifold(mesh, *opposites, &stage)) {
    return find_closed_findings(mesh, *opposites, stage);
  }
  Stage full(progress, "listing faults of " + mesh.name, count, kStepsOfFaultFinder * count);
  const MeshAdjacency adjacency(mesh);
  full.add(2 * count);
  return FaultFinder(mesh, adjacency).find(&full);
}

MeshFindings find_mesh_findings(const BuiltMesh& built, const ProgressCall& progress) {
  MeshFindings found = find_mesh_findings(built.mesh, progress);
  found.degenerate_triangles = built.degenerate;
  found.collinear_triangles = built.collinear;
  found.opposite_normals = built.opposite_normals;
  return found;
}

}  // namespace gouge
