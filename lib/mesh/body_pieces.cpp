#include "lib/mesh/body_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>

#include "lib/base/tolerance.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/double_walls.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/union_find.h"

namespace gouge {
namespace {

constexpr std::uint32_t kNoMate = std::numeric_limits<std::uint32_t>::max();

/// A triangle at an edge, in the view along the edge from its lower vertex to its higher one.
struct Leaf {
  std::uint32_t side = 0;
  bool is_forward = false;  // its material is at smaller angles
  double angle = 0;         // in [0, 2 pi)
};

class Pairer {
 public:
  explicit Pairer(const IndexedMesh& mesh)
      : mesh_(mesh), adjacency_(mesh), mates_(3 * mesh.triangles.size(), kNoMate) {}

  std::vector<std::uint32_t> pair() {
    for (std::uint32_t e = 0; e < adjacency_.edges().size(); ++e) {
      const MeshEdge& edge = adjacency_.edges()[e];
      if (edge.use_count % 2 == 0) pair_at(e, edge);
    }
    return std::move(mates_);
  }

  [[nodiscard]] const MeshAdjacency& adjacency() const { return adjacency_; }

 private:
  void pair_at(std::uint32_t e, const MeshEdge& edge) {
    std::vector<Leaf> leaves;
    for (const EdgeUse& use : adjacency_.uses(edge)) {
      const auto& edges = adjacency_.edges_of_triangle(use.triangle);
      const auto k = static_cast<std::uint32_t>(std::find(edges.begin(), edges.end(), e) - edges.begin());
      leaves.push_back({3 * use.triangle + k, use.is_forward, 0});
    }
    if (leaves.size() > 2) sort_around(edge, leaves);
    const auto forward = std::count_if(leaves.begin(), leaves.end(), [](const Leaf& l) { return l.is_forward; });
    if (2 * static_cast<std::size_t>(forward) == leaves.size())
      pair_by_material(leaves);
    else
      for (std::size_t i = 0; i < leaves.size(); i += 2) join(leaves[i], leaves[i + 1]);
  }

  /// Sorts the triangles by angle. At equal angles, one that ends material comes before one that begins material.
  void sort_around(const MeshEdge& edge, std::vector<Leaf>& leaves) const {
    const Vec3 low = mesh_.vertices[edge.low], along = (mesh_.vertices[edge.high] - low).normalized();
    const auto away = [&](const Leaf& leaf) {
      const Vec3 v = mesh_.corner(leaf.side / 3, (leaf.side % 3 + 2) % 3) - low;
      return Vec3(v - v.dot(along) * along);
    };
    const Vec3 e1 = away(leaves[0]).normalized(), e2 = along.cross(e1);
    constexpr double kStep = Tolerance::kRounding, kTurn = 2 * std::numbers::pi;
    for (Leaf& leaf : leaves) {
      const Vec3 v = away(leaf);
      const double angle = std::round(std::atan2(v.dot(e2), v.dot(e1)) / kStep) * kStep;
      leaf.angle = angle < 0 ? std::min(angle + kTurn, kTurn) : angle;
    }
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
      return std::tuple(a.angle, !a.is_forward, a.side) < std::tuple(b.angle, !b.is_forward, b.side);
    });
  }

  /// Pairs the sides around the edge like brackets: material begins at a backward side and ends at the matching forward
  /// side.
  void pair_by_material(const std::vector<Leaf>& leaves) {
    std::vector<Leaf> begun, ended;
    for (const Leaf& leaf : leaves) {
      if (!leaf.is_forward) {
        begun.push_back(leaf);
      } else if (begun.empty()) {
        ended.push_back(leaf);
      } else {
        join(begun.back(), leaf);
        begun.pop_back();
      }
    }
    for (const Leaf& leaf : ended) {
      join(begun.back(), leaf);
      begun.pop_back();
    }
  }

  void join(const Leaf& a, const Leaf& b) {
    mates_[a.side] = b.side;
    mates_[b.side] = a.side;
  }

  const IndexedMesh& mesh_;
  MeshAdjacency adjacency_;
  std::vector<std::uint32_t> mates_;
};

std::vector<std::uint32_t> roots_of(UnionFind& sets, std::size_t count) {
  std::vector<std::uint32_t> roots(count);
  for (std::uint32_t i = 0; i < count; ++i) roots[i] = sets.root(i);
  return roots;
}

std::uint32_t next_corner(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }

/// Marks the pinched pieces. Two triangles belong to one fan at a vertex if their sides from it are mates.
void mark_pinched(const IndexedMesh& mesh, const std::vector<std::uint32_t>& mates, SurfacePieces& pieces) {
  UnionFind fans(mates.size()), by_edges(mesh.triangles.size());
  const auto corner = [&](std::uint32_t c) { return mesh.triangles[c / 3][c % 3]; };
  for (std::uint32_t side = 0; side < mates.size(); ++side) {
    const std::uint32_t mate = mates[side];
    if (mate == kNoMate || mate < side) continue;
    const bool is_back = corner(mate) != corner(side);
    fans.join(side, is_back ? next_corner(mate) : mate);
    fans.join(next_corner(side), is_back ? mate : next_corner(mate));
  }
  std::vector<std::tuple<Corner, Corner, std::uint32_t>> edges;
  for (std::uint32_t side = 0; side < mates.size(); ++side) {
    const Corner from = corner(side), to = corner(next_corner(side));
    edges.emplace_back(std::min(from, to), std::max(from, to), side / 3);
  }
  const auto is_same_edge = [](const auto& a, const auto& b) {
    return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b);
  };
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (is_same_edge(edges[i], edges[i - 1])) by_edges.join(std::get<2>(edges[i]), std::get<2>(edges[i - 1]));
  }
  std::vector<bool> is_pinched(mesh.triangles.size(), false);
  std::vector<std::tuple<Corner, std::uint32_t, std::uint32_t>> ends;  // vertex, part connected by edges, fan
  for (std::uint32_t c = 0; c < mates.size(); ++c) ends.emplace_back(corner(c), by_edges.root(c / 3), fans.root(c));
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const auto& [vertex, whole, fan] = ends[i];
    const auto& [vertex0, whole0, fan0] = ends[i - 1];
    if (vertex == vertex0 && whole == whole0 && fan != fan0) is_pinched[whole] = true;
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_pinched[by_edges.root(t)]) pieces.is_pinched[pieces.piece_of[t]] = true;
  }
}

}  // namespace

SurfacePieces find_pieces(const IndexedMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  SurfacePieces pieces{{}, std::vector<bool>(count, false), std::vector<bool>(count, false)};
  UnionFind joins(count);
  if (const auto opposites = find_opposite_half_edges(mesh)) {
    for (std::uint32_t side = 0; side < opposites->size(); ++side) joins.join(side / 3, (*opposites)[side] / 3);
    pieces.piece_of = roots_of(joins, count);
    if (!is_manifold(mesh, *opposites)) mark_pinched(mesh, *opposites, pieces);
    return pieces;
  }
  Pairer pairer(mesh);
  const std::vector<std::uint32_t> mates = pairer.pair();
  for (std::uint32_t side = 0; side < mates.size(); ++side) {
    if (mates[side] != kNoMate) joins.join(side / 3, mates[side] / 3);
  }
  const MeshAdjacency& adjacency = pairer.adjacency();
  for (const MeshEdge& edge : adjacency.edges()) {
    if (edge.use_count % 2 == 0) continue;
    for (const EdgeUse& use : adjacency.uses(edge)) joins.join(adjacency.uses(edge)[0].triangle, use.triangle);
  }
  pieces.piece_of = roots_of(joins, count);
  for (const MeshEdge& edge : adjacency.edges()) {
    if (edge.use_count % 2 != 0) pieces.is_open[pieces.piece_of[adjacency.uses(edge)[0].triangle]] = true;
  }
  mark_pinched(mesh, mates, pieces);
  return pieces;
}

BodyPieces find_body_pieces(const IndexedMesh& mesh) {
  const SurfacePieces pieces = find_pieces(mesh);
  const std::vector<bool> is_double = find_double_walls(mesh, pieces);
  BodyPieces found;
  found.sound.vertices = mesh.vertices;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t piece = pieces.piece_of[t];
    if (!pieces.is_open[piece] && !is_double[piece]) {
      found.sound.triangles.push_back(mesh.triangles[t]);
      found.origin.push_back(t);
      continue;
    }
    if (piece == t && is_double[piece] && found.double_walls++ == 0) found.double_at = t;
    for (std::size_t k = 0; k < 3; ++k) found.doubtful_box.extend(mesh.corner(t, k));
  }
  return found;
}

}  // namespace gouge
