#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "lib/validate/cgal_bridge.h"
#include "lib/validate/cgal_guard.h"

namespace gouge::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

// Decides whether two triangles of a mesh have more in common than their shared corners.
class TrianglePairs {
 public:
  explicit TrianglePairs(const IndexedMesh& mesh) : mesh_(mesh) {
    points_.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) points_.emplace_back(v.x(), v.y(), v.z());
  }

  [[nodiscard]] bool has_area(std::uint32_t t) const { return !CGAL::collinear(point(t, 0), point(t, 1), point(t, 2)); }

  [[nodiscard]] CGAL::Bbox_3 box(std::uint32_t t) const { return triangle(t).bbox(); }

  [[nodiscard]] bool do_cross(std::uint32_t t, std::uint32_t u) const {
    const TriangleCorners a = shared_first(t, u);
    const TriangleCorners b = shared_first(u, t);
    switch (shared_count(t, u)) {
      case 0:
        return CGAL::do_intersect(triangle(t), triangle(u));
      case 1:  // away from the shared corner, one triangle's far side must meet the other triangle
        return CGAL::do_intersect(segment(a[1], a[2]), triangle(u)) ||
               CGAL::do_intersect(segment(b[1], b[2]), triangle(t));
      case 2: {  // folded onto each other
        const Point& p = points_[a[0]];
        const Point& q = points_[a[1]];
        return CGAL::coplanar(p, q, points_[a[2]], points_[b[2]]) &&
               CGAL::coplanar_orientation(p, q, points_[a[2]], points_[b[2]]) == CGAL::POSITIVE;
      }
      default:
        return false;
    }
  }

  // A point two crossing triangles share: where a side of one passes through the other, to rounding; for
  // triangles in one plane a corner inside the other or where sides cross is near enough: the middle of their
  // common box.
  [[nodiscard]] Vec3 meeting_point(std::uint32_t t, std::uint32_t u) const {
    for (const auto& [one, other] : {std::pair(t, u), std::pair(u, t)}) {
      const TriangleCorners corners = shared_first(one, other);
      const std::size_t shared = shared_count(t, u);
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner from = corners[k];
        const Corner to = corners[(k + 1) % 3];
        if (shared > 0 && (k == 0 || k == 2)) continue;  // these sides start at the shared corner
        if (!CGAL::do_intersect(segment(from, to), triangle(other))) continue;
        if (const auto place = through_plane(mesh_.vertices[from], mesh_.vertices[to], other)) return *place;
      }
    }
    Box3 common = mesh_box(t).intersection(mesh_box(u));
    return common.center();
  }

 private:
  [[nodiscard]] const Point& point(std::uint32_t t, std::size_t k) const { return points_[mesh_.triangles[t][k]]; }
  [[nodiscard]] Triangle triangle(std::uint32_t t) const { return {point(t, 0), point(t, 1), point(t, 2)}; }
  [[nodiscard]] Segment segment(Corner from, Corner to) const { return {points_[from], points_[to]}; }

  [[nodiscard]] Box3 mesh_box(std::uint32_t t) const {
    Box3 box(mesh_.corner(t, 0));
    box.extend(mesh_.corner(t, 1));
    box.extend(mesh_.corner(t, 2));
    return box;
  }

  [[nodiscard]] bool is_corner(Corner c, std::uint32_t t) const {
    const TriangleCorners& corners = mesh_.triangles[t];
    return corners[0] == c || corners[1] == c || corners[2] == c;
  }

  [[nodiscard]] std::size_t shared_count(std::uint32_t t, std::uint32_t u) const {
    const TriangleCorners& corners = mesh_.triangles[t];
    return static_cast<std::size_t>(
        std::count_if(corners.begin(), corners.end(), [&](Corner c) { return is_corner(c, u); }));
  }

  // The corners of t, those it shares with u first.
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
  std::vector<Point> points_;
};

// One triangle for each set of corners: the copies of a duplicated triangle say nothing new.
std::vector<std::uint32_t> distinct_triangles(const IndexedMesh& mesh) {
  std::vector<std::pair<TriangleCorners, std::uint32_t>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleCorners corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, t);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto last =
      std::unique(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  std::vector<std::uint32_t> distinct;
  for (auto it = sorted.begin(); it != last; ++it) distinct.push_back(it->second);
  std::sort(distinct.begin(), distinct.end());
  return distinct;
}

}  // namespace

Result<SelfIntersections> find_self_intersections(const IndexedMesh& mesh) {
  return guarded<SelfIntersections>("find self-intersections", [&] {
    const TrianglePairs pairs(mesh);
    std::vector<Box> boxes;
    for (const std::uint32_t t : distinct_triangles(mesh)) {
      if (pairs.has_area(t)) boxes.emplace_back(pairs.box(t), t);
    }
    std::vector<const Box*> pointers;
    for (const Box& box : boxes) pointers.push_back(&box);
    SelfIntersections found;
    std::pair<std::uint32_t, std::uint32_t> first;
    const auto test = [&](const Box* one, const Box* other) {
      const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax({one->info(), other->info()});
      if (!pairs.do_cross(pair.first, pair.second)) return;
      if (found.pairs++ == 0 || pair < first) first = pair;
    };
    CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), test);
    if (found.pairs > 0) {
      found.first_triangle = mesh.file_triangle[first.first];
      found.second_triangle = mesh.file_triangle[first.second];
      found.position_mm = pairs.meeting_point(first.first, first.second);
    }
    return found;
  });
}

}  // namespace gouge::detail
