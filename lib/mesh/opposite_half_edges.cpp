#include "lib/mesh/opposite_half_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "lib/base/large_pages.h"

namespace gouge {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMaxTriangles = 350'000'000;  // a side and two flag bits fit in 32 bits

/// An edge in the list of its lower vertex.
struct Edge {
  Corner high = 0;
  std::uint32_t marked_side = 0;  // its first side, times 4; plus 2: has its opposite; plus 1: runs upward
  std::uint32_t next = kNone;
};

class Matcher {
 public:
  explicit Matcher(const IndexedMesh& mesh)
      : mesh_(mesh), sides_(3 * mesh.triangles.size()), first_(mesh.vertices.size(), kNone) {
    reserve_large(edges_, sides_ / 2);
    reserve_large(opposites_, sides_);
    opposites_.resize(sides_);
  }

  std::optional<OppositeHalfEdges> match(Stage* stage) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (stage != nullptr) stage->pass(t, 3);
      const TriangleCorners& c = mesh_.triangles[t];
      if (!add(3 * t, c[0], c[1]) || !add(3 * t + 1, c[1], c[2]) || !add(3 * t + 2, c[2], c[0])) return std::nullopt;
    }
    // There are half as many edges as sides, and each has an opposite: `add` rejects any other surface.
    if (matched_ != edges_.size()) return std::nullopt;
    return std::move(opposites_);
  }

 private:
  /// Adds a side. Returns false if some edge cannot have exactly one opposite.
  bool add(std::uint32_t side, Corner from, Corner to) {
    const std::uint32_t upward = from < to ? 1 : 0;
    const Corner low = std::min(from, to), high = std::max(from, to);
    for (std::uint32_t e = first_[low]; e != kNone; e = edges_[e].next) {
      Edge& edge = edges_[e];
      if (edge.high != high) continue;
      if ((edge.marked_side & 3U) != (upward ^ 1U)) return false;
      opposites_[side] = edge.marked_side >> 2U;
      opposites_[edge.marked_side >> 2U] = side;
      edge.marked_side |= 2U;
      ++matched_;
      return true;
    }
    if (low == high || edges_.size() == sides_ / 2) return false;
    edges_.push_back({high, side << 2U | upward, first_[low]});
    first_[low] = static_cast<std::uint32_t>(edges_.size() - 1);
    return true;
  }

  const IndexedMesh& mesh_;
  std::size_t sides_;
  std::vector<std::uint32_t> first_;  // for each vertex: the start of its list
  std::vector<Edge> edges_;
  OppositeHalfEdges opposites_;
  std::size_t matched_ = 0;
};

std::uint32_t after(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }

}  // namespace

std::optional<OppositeHalfEdges> find_opposite_half_edges(const IndexedMesh& mesh, Stage* stage) {
  if (mesh.triangles.size() > kMaxTriangles) return std::nullopt;
  return Matcher(mesh).match(stage);
}

bool is_manifold(const IndexedMesh& mesh, const OppositeHalfEdges& opposites, Stage* stage) {
  std::vector<bool> is_seen(mesh.vertices.size(), false);
  std::size_t corners = 0;  // number of corners in the first fan of each vertex
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (stage != nullptr) stage->pass(t);
    const std::uint32_t a = opposites[3 * t] / 3, b = opposites[3 * t + 1] / 3, c = opposites[3 * t + 2] / 3;
    if (a == b || b == c || c == a) return false;  // two common edges: the triangles have the same corners
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (is_seen[mesh.triangles[t][k]]) continue;
      is_seen[mesh.triangles[t][k]] = true;
      const std::uint32_t start = 3 * t + k;
      std::uint32_t side = start;
      do {
        side = after(opposites[side]);
        ++corners;
      } while (side != start);
    }
  }
  return corners == opposites.size();
}

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 pa = a - point;
  const Vec3 pb = b - point;
  const Vec3 pc = c - point;
  const double la = pa.norm();
  const double lb = pb.norm();
  const double lc = pc.norm();
  const double volume = pa.dot(pb.cross(pc));
  const double across = la * lb * lc + pa.dot(pb) * lc + pb.dot(pc) * la + pc.dot(pa) * lb;
  return 2 * std::atan2(volume, across);
}

double winding_number(const IndexedMesh& mesh, const Vec3& point_part) {
  double sum = 0;
  for (const TriangleCorners& t : mesh.triangles) {
    sum += solid_angle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], point_part);
  }
  return sum / (4 * std::numbers::pi);
}

bool is_inside(std::span<const IndexedMesh> meshes, const Vec3& point_part) {
  double winding = 0;
  for (const IndexedMesh& mesh : meshes) winding += winding_number(mesh, point_part);
  return std::abs(winding) > 0.5;
}

}  // namespace gouge
