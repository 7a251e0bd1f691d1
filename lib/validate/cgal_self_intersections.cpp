#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/validate/cgal_bridge.h"
#include "lib/validate/cgal_guard.h"

namespace gouge::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;

Point to_point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Exact tests of whether two triangles of a mesh have more in common than their shared corners.
class TrianglePairs {
 public:
  explicit TrianglePairs(const IndexedMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] bool has_area(std::uint32_t t) const {
    return !CGAL::collinear(corner(t, 0), corner(t, 1), corner(t, 2));
  }

  [[nodiscard]] bool do_cross(std::uint32_t t, std::uint32_t u) const {
    const TriangleCorners a = shared_first(t, u);
    const TriangleCorners b = shared_first(u, t);
    switch (shared_count(t, u)) {
      case 0:
        return CGAL::do_intersect(triangle(t), triangle(u));
      case 1:  // the side opposite the shared corner of one triangle must meet the other triangle
        return CGAL::do_intersect(segment(a[1], a[2]), triangle(u)) ||
               CGAL::do_intersect(segment(b[1], b[2]), triangle(t));
      case 2: {  // crossing means folded onto each other
        const Point p = point(a[0]), q = point(a[1]), r = point(a[2]), s = point(b[2]);
        return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
      }
      default:
        return false;
    }
  }

  // Returns a common point of two crossing triangles, up to rounding: the point where a side of one passes through the
  // other. For triangles in one plane it is the middle of their common box. That is near a corner inside the other
  // triangle or a crossing of sides.
  [[nodiscard]] Vec3 meeting_point(std::uint32_t t, std::uint32_t u) const {
    for (const auto& [one, other] : {std::pair(t, u), std::pair(u, t)}) {
      const TriangleCorners corners = shared_first(one, other);
      const std::size_t shared = shared_count(t, u);
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner from = corners[k];
        const Corner to = corners[(k + 1) % 3];
        if (shared > 0 && (k == 0 || k == 2)) continue;  // these sides contain the shared corner
        if (!CGAL::do_intersect(segment(from, to), triangle(other))) continue;
        if (const auto place = through_plane(mesh_.vertices[from], mesh_.vertices[to], other)) return *place;
      }
    }
    Box3 common = box_of(mesh_, t).intersection(box_of(mesh_, u));
    return common.center();
  }

 private:
  [[nodiscard]] Point point(Corner c) const { return to_point(mesh_.vertices[c]); }
  [[nodiscard]] Point corner(std::uint32_t t, std::size_t k) const { return to_point(mesh_.corner(t, k)); }
  [[nodiscard]] Triangle triangle(std::uint32_t t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }
  [[nodiscard]] Segment segment(Corner from, Corner to) const { return {point(from), point(to)}; }

  [[nodiscard]] bool is_corner(Corner c, std::uint32_t t) const {
    const TriangleCorners& corners = mesh_.triangles[t];
    return corners[0] == c || corners[1] == c || corners[2] == c;
  }

  [[nodiscard]] std::size_t shared_count(std::uint32_t t, std::uint32_t u) const {
    const TriangleCorners& corners = mesh_.triangles[t];
    return static_cast<std::size_t>(
        std::count_if(corners.begin(), corners.end(), [&](Corner c) { return is_corner(c, u); }));
  }

  // Returns the corners of t. The corners shared with u are first.
  [[nodiscard]] TriangleCorners shared_first(std::uint32_t t, std::uint32_t u) const {
    TriangleCorners corners = mesh_.triangles[t];
    std::stable_partition(corners.begin(), corners.end(), [&](Corner c) { return is_corner(c, u); });
    return corners;
  }

  [[nodiscard]] std::optional<Vec3> through_plane(const Vec3& from, const Vec3& to, std::uint32_t t) const {
    const Vec3& a = mesh_.corner(t, 0);
    const Vec3 normal = (mesh_.corner(t, 1) - a).cross(mesh_.corner(t, 2) - a);
    const double height_from = normal.dot(from - a);
    const double height_to = normal.dot(to - a);
    if ((height_from > 0) == (height_to > 0)) return std::nullopt;
    return from + (to - from) * (height_from / (height_from - height_to));
  }

  const IndexedMesh& mesh_;
};

constexpr const char* kTask = "find self-intersections";

}  // namespace

Result<std::vector<std::uint32_t>> without_area(const IndexedMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  return guarded<std::vector<std::uint32_t>>(kTask, [&] {
    const TrianglePairs pairs(mesh);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t t : triangles) {
      if (!pairs.has_area(t)) found.push_back(t);
    }
    return found;
  });
}

Result<std::vector<TrianglePair>> crossing_pairs(const IndexedMesh& mesh, const std::vector<TrianglePair>& pairs) {
  return guarded<std::vector<TrianglePair>>(kTask, [&] {
    const TrianglePairs exact(mesh);
    std::vector<TrianglePair> found;
    for (const TrianglePair& pair : pairs) {
      if (exact.do_cross(pair.first, pair.second)) found.push_back(pair);
    }
    return found;
  });
}

Result<Vec3> meeting_point(const IndexedMesh& mesh, const TrianglePair& pair) {
  return guarded<Vec3>(kTask, [&] { return TrianglePairs(mesh).meeting_point(pair.first, pair.second); });
}

}  // namespace gouge::detail
