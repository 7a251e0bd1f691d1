#include "lib/clash/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/geom/point_triangle.h"

namespace gouge {
namespace {

void take(const Vec3& a, const Vec3& b, ClosestPair& best) {
  const double distance = (b - a).norm();
  if (distance < best.distance_mm) best = {a, b, distance};
}

/// Closest points of two edges.
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

/// Where an edge passes through the plane of a triangle: the triangles cross if that point is on the
/// triangle.
std::array<Vec3, 2> on_plane(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double here = normal.dot(from - triangle[0]), there = normal.dot(to - triangle[0]);
  const bool is_through = (here <= 0 && there > 0) || (here >= 0 && there < 0);
  const Vec3 point = is_through ? Vec3(from + here / (here - there) * (to - from)) : from;
  return {point, closest_on_triangle(point, triangle).point};
}

/// Depth-first over pairs of nodes, the nearer pair first.
class Search {
 public:
  Search(const DepthBody& a, const DepthBody& b, const Vec3& shift, double enough_mm)
      : a_(a), b_(b), shift_(shift), enough_mm_(enough_mm) {
    best_.distance_mm = std::numeric_limits<double>::infinity();
  }

  ClosestPair run() {
    visit(0, 0);
    return best_;
  }

 private:
  [[nodiscard]] bool is_done() const { return best_.distance_mm <= enough_mm_; }

  [[nodiscard]] double least_mm(std::uint32_t a, std::uint32_t b) const {
    const float* const box_a = a_.boxes.data() + 6 * std::size_t{a};
    const float* const box_b = b_.boxes.data() + 6 * std::size_t{b};
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double above = static_cast<double>(box_b[i]) + shift_[i] - static_cast<double>(box_a[i + 3]);
      const double below = static_cast<double>(box_a[i]) - shift_[i] - static_cast<double>(box_b[i + 3]);
      const double out = std::max({above, below, 0.0});
      sum += out * out;
    }
    return std::sqrt(sum);
  }

  static double size2(const DepthBody& body, std::uint32_t node) {
    const float* const box = body.boxes.data() + 6 * std::size_t{node};
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += std::pow(static_cast<double>(box[i + 3] - box[i]), 2);
    return sum;
  }

  void visit(std::uint32_t a, std::uint32_t b) {
    const KdopNode &node_a = a_.tree.nodes[a], &node_b = b_.tree.nodes[b];
    if (node_a.children == 0 && node_b.children == 0) return meet(node_a, node_b);
    const bool opens_a = node_b.children == 0 || (node_a.children > 0 && size2(a_, a) >= size2(b_, b));
    const KdopNode& opened = opens_a ? node_a : node_b;
    std::array<std::pair<double, std::uint32_t>, 8> near;
    for (std::uint32_t k = 0; k < opened.children; ++k) {
      const std::uint32_t child = opened.first + k;
      const double least = opens_a ? least_mm(child, b) : least_mm(a, child);
      std::size_t at = k;
      for (; at > 0 && near[at - 1].first > least; --at) near[at] = near[at - 1];
      near[at] = {least, child};
    }
    for (std::uint32_t k = 0; k < opened.children && !is_done(); ++k) {
      if (near[k].first >= best_.distance_mm) return;
      opens_a ? visit(near[k].second, b) : visit(a, near[k].second);
    }
  }

  void meet(const KdopNode& a, const KdopNode& b) {
    for (std::uint32_t i = 0; i < a.item_count; ++i) {
      for (std::uint32_t j = 0; j < b.item_count && !is_done(); ++j) {
        std::array<Vec3, 3> moved = b_.corners[b.first + j];
        for (Vec3& corner : moved) corner += shift_;
        const ClosestPair found = closest_points(a_.corners[a.first + i], moved);
        if (found.distance_mm < best_.distance_mm) best_ = found;
      }
    }
  }

  const DepthBody& a_;
  const DepthBody& b_;
  Vec3 shift_;
  double enough_mm_;
  ClosestPair best_;
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

ClosestPair surface_distance(const DepthBody& a, const DepthBody& b, const Vec3& shift, double enough_mm) {
  return Search(a, b, shift, enough_mm).run();
}

}  // namespace gouge
