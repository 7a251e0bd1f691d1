#include "lib/clash/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/lane_bound.h"

namespace gouge {
namespace {

void take(const Vec3& a, const Vec3& b, ClosestPair& best) {
  const double distance = (b - a).norm();
  if (distance < best.distance_mm) best = {a, b, distance};
}

/// Finds the closest points of two edges.
/// Source   C. Ericson, Real-Time Collision Detection (2005), 5.1.9.
void take_edges(const Vec3& a, const Vec3& a_end, const Vec3& b, const Vec3& b_end, ClosestPair& best) {
  const Vec3 along_a = a_end - a, along_b = b_end - b, between = a - b;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  const double da = along_a.dot(between), db = along_b.dot(between);
  const double across = aa * bb - ab * ab;
  double s = across > 0 ? std::clamp((ab * db - da * bb) / across, 0.0, 1.0) : 0.0;
  double t = bb > 0 ? (ab * s + db) / bb : 0.0;
  if (!(t >= 0 && t <= 1)) {
    t = std::clamp(t, 0.0, 1.0);
    s = aa > 0 ? std::clamp((ab * t - da) / aa, 0.0, 1.0) : 0.0;
  }
  take(a + s * along_a, b + t * along_b, best);
}

/// Returns the point at which an edge passes through the plane of a triangle, and the triangle's closest point to it.
/// The triangles cross if these are equal.
std::array<Vec3, 2> on_plane(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double here = normal.dot(from - triangle[0]), there = normal.dot(to - triangle[0]);
  const bool is_through = (here <= 0 && there > 0) || (here >= 0 && there < 0);
  const Vec3 point = is_through ? Vec3(from + here / (here - there) * (to - from)) : from;
  return {point, closest_on_triangle(point, triangle).point};
}

Box3 box_around(const std::array<Vec3, 3>& triangle) {
  Box3 box;
  for (const Vec3& corner : triangle) box.extend(corner);
  return box;
}

/// Depth-first search over pairs of nodes, the nearer pair first.
class PairSearch {
 public:
  PairSearch(const Surface& a, const Surface& b, const Vec3& shift, double cutoff_mm)
      : a_(a), b_(b), shift_(shift), cutoff_mm_(cutoff_mm) {
    best_.distance_mm = std::numeric_limits<double>::infinity();
  }

  ClosestPair run() {
    visit(Node(a_.tree()), Node(b_.tree()));
    return best_;
  }

 private:
  /// A node or a leaf of a tree, and its bounding volume.
  struct Node {
    explicit Node(const BlockTree& tree) : bound(tree) {}
    Node(const BlockTree& tree, const NodeBlock& parent, std::size_t lane)
        : bound(tree, parent, lane), index(parent.child[lane]), is_leaf(parent.has_leaves) {}

    LaneBound bound;
    std::uint32_t index = 0;
    bool is_leaf = false;
  };

  [[nodiscard]] bool is_done() const { return best_.distance_mm <= cutoff_mm_; }

  /// Returns a lower bound of the distance: if two bodies are apart along some direction, they are at least that far
  /// apart.
  [[nodiscard]] double min_mm(const Node& a, const Node& b) const {
    const Vec3 between = b.bound.center + shift_ - a.bound.center;
    double least = 0;
    for (const Vec3& direction : {between, a.bound.normal, b.bound.normal}) {
      const double length = direction.norm();
      if (!(length > 0)) continue;
      const Vec3 unit = direction / length;
      least = std::max(least, std::abs(unit.dot(between)) - a.bound.extent_mm(unit) - b.bound.extent_mm(unit));
    }
    return std::max(0.0, least - Tolerance::kRounding_mm);
  }

  void visit(const Node& a, const Node& b) {
    if (a.is_leaf && b.is_leaf) return meet(a_.tree().leaves[a.index], b_.tree().leaves[b.index]);
    const bool opens_a = b.is_leaf || (!a.is_leaf && a.bound.radius_mm >= b.bound.radius_mm);
    const BlockTree& tree = opens_a ? a_.tree() : b_.tree();
    const NodeBlock& opened = tree.nodes[opens_a ? a.index : b.index];
    std::array<std::pair<double, std::size_t>, kBlockLanes> near;
    for (std::size_t lane = 0; lane < opened.count; ++lane) {
      const Node child(tree, opened, lane);
      const double least = opens_a ? min_mm(child, b) : min_mm(a, child);
      std::size_t at = lane;
      for (; at > 0 && near[at - 1].first > least; --at) near[at] = near[at - 1];
      near[at] = {least, lane};
    }
    for (std::size_t k = 0; k < opened.count && !is_done(); ++k) {
      if (near[k].first >= best_.distance_mm) return;
      const Node child(tree, opened, near[k].second);
      opens_a ? visit(child, b) : visit(a, child);
    }
  }

  struct FacetPair {
    double least2 = 0;
    std::size_t a = 0, b = 0;
  };

  /// Examines the pairs of facets in the order of their boxes' distances.
  void meet(const TriangleBlock& a, const TriangleBlock& b) {
    std::array<std::array<Vec3, 3>, kBlockLanes> facets_b;
    std::array<Box3, kBlockLanes> boxes_b;
    for (std::size_t j = 0; j < b.count; ++j) {
      facets_b[j] = b_.corners(b.triangle[j]);
      for (Vec3& corner : facets_b[j]) corner += shift_;
      boxes_b[j] = box_around(facets_b[j]);
    }
    pairs_.clear();
    for (std::size_t i = 0; i < a.count; ++i) {
      const Box3 box = box_around(a_.corners(a.triangle[i]));
      for (std::size_t j = 0; j < b.count; ++j) pairs_.push_back({box.squaredExteriorDistance(boxes_b[j]), i, j});
    }
    std::sort(pairs_.begin(), pairs_.end(), [](const FacetPair& one, const FacetPair& other) {
      return std::tie(one.least2, one.a, one.b) < std::tie(other.least2, other.a, other.b);
    });
    for (const FacetPair& pair : pairs_) {
      if (is_done() || std::sqrt(pair.least2) - Tolerance::kRounding_mm >= best_.distance_mm) return;
      const ClosestPair found = closest_points(a_.corners(a.triangle[pair.a]), facets_b[pair.b]);
      if (found.distance_mm < best_.distance_mm) best_ = found;
    }
  }

  const Surface& a_;
  const Surface& b_;
  Vec3 shift_;
  double cutoff_mm_;
  ClosestPair best_;
  std::vector<FacetPair> pairs_;
};

}  // namespace

ClosestPair closest_points(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  ClosestPair best;
  best.distance_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &from_a = a[i], &to_a = a[(i + 1) % 3];
    take(from_a, closest_on_triangle(from_a, b).point, best);
    take(closest_on_triangle(b[i], a).point, b[i], best);
    const std::array<Vec3, 2> through_b = on_plane(from_a, to_a, b), through_a = on_plane(b[i], b[(i + 1) % 3], a);
    take(through_b[0], through_b[1], best);
    take(through_a[1], through_a[0], best);
    for (std::size_t j = 0; j < 3; ++j) take_edges(from_a, to_a, b[j], b[(j + 1) % 3], best);
  }
  return best;
}

ClosestPair surface_distance(const Surface& a, const Surface& b, const Vec3& shift, double cutoff_mm) {
  return PairSearch(a, b, shift, cutoff_mm).run();
}

}  // namespace gouge
