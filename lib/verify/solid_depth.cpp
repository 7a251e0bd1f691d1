#include "lib/verify/solid_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "lib/geom/point_triangle.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/opposite_half_edges.h"

namespace gouge {
namespace {

constexpr double kBeside_mm = 1e-7;  // distance from a triangle at which both of its sides are tested
constexpr double kAround_mm = 1e-5;  // distance from a point on a triangle at which the parts that meet there are
                                     // tested
constexpr double kOn_mm = 1e-9;      // a point this near to a triangle counts as on it
constexpr int kDirections = 24;

using Triangle = std::array<Vec3, 3>;

Box3 box_around(const Triangle& triangle) {
  Box3 box;
  for (const Vec3& corner : triangle) box.extend(corner);
  return Box3(Vec3(box.min().array() - kOn_mm), Vec3(box.max().array() + kOn_mm));
}

/// Adds the points where the edges of `a` pass through the plane of `b` or end on it, within `b`.
void add_piercings(const Triangle& a, const Triangle& b, std::vector<Vec3>& points) {
  const Vec3 normal = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &from = a[k], &to = a[(k + 1) % 3];
    const double here = normal.dot(from - b[0]), there = normal.dot(to - b[0]);
    const bool is_on = std::abs(here) <= kOn_mm;
    if (!is_on && !((here > 0 && there < 0) || (here < 0 && there > 0))) continue;
    const Vec3 point = is_on ? from : Vec3(from + here / (here - there) * (to - from));
    if (closest_on_triangle(point, b).distance2_mm2 <= kOn_mm * kOn_mm) points.push_back(point);
  }
}

bool is_in_plane(const Triangle& a, const Triangle& b) {
  const Vec3 normal = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
  return std::all_of(a.begin(), a.end(), [&](const Vec3& x) { return std::abs(normal.dot(x - b[0])) <= kOn_mm; });
}

/// Returns whether two triangles of one plane have more in common than a line. Clips `a` by the edges of `b`.
bool is_overlapping(const Triangle& a, const Triangle& b) {
  const Vec3 normal = (b[1] - b[0]).cross(b[2] - b[0]).normalized();
  std::vector<Vec3> left(a.begin(), a.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 inward = normal.cross(b[(k + 1) % 3] - b[k]).normalized();
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Vec3 &from = left[i], &to = left[(i + 1) % left.size()];
      const double here = inward.dot(from - b[k]) - kOn_mm, there = inward.dot(to - b[k]) - kOn_mm;
      if (here > 0) kept.push_back(from);
      if ((here > 0) != (there > 0)) kept.push_back(from + here / (here - there) * (to - from));
    }
    left = std::move(kept);
  }
  double widest = 0;
  for (std::size_t i = 2; i < left.size(); ++i)
    widest = std::max(widest, (left[i - 1] - left[0]).cross(left[i] - left[0]).norm());
  return widest > 0;
}

Vec3 closest_on(const std::array<Vec3, 2>& segment, const Vec3& point) {
  const Vec3 along = segment[1] - segment[0];
  const double length2 = along.squaredNorm();
  return segment[0] + (length2 > 0 ? std::clamp(along.dot(point - segment[0]) / length2, 0.0, 1.0) : 0.0) * along;
}

/// Returns the point where two segments of one plane cross; nothing if they are parallel or do not meet.
std::optional<Vec3> crossing_of(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  const Vec3 u = a[1] - a[0], v = b[1] - b[0], w = b[0] - a[0];
  const Vec3 normal = u.cross(v);
  const double area2 = normal.squaredNorm();
  if (!(area2 > 1e-24 * u.squaredNorm() * v.squaredNorm())) return std::nullopt;
  const double s = w.cross(v).dot(normal) / area2, t = w.cross(u).dot(normal) / area2;
  if (s < -1e-9 || s > 1 + 1e-9 || t < -1e-9 || t > 1 + 1e-9) return std::nullopt;
  return a[0] + s * u;
}

}  // namespace

SolidDepth::SolidDepth(const IndexedMesh& mesh) : mesh_(&mesh), box_(mesh.box()), crossings_(mesh.triangles.size()) {
  find_crossings();
}

/// Finds the triangles that meet. Compares the boxes of triangles, sorted by their lowest x.
void SolidDepth::find_crossings() {
  std::vector<Box3> boxes(mesh_->triangles.size());
  for (std::uint32_t t = 0; t < boxes.size(); ++t) boxes[t] = box_around(corners(t));
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(boxes[a].min().x(), a) < std::pair(boxes[b].min().x(), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min().x() <= boxes[order[i]].max().x(); ++j) {
      if (boxes[order[i]].intersects(boxes[order[j]])) add_crossing(order[i], order[j]);
    }
  }
}

void SolidDepth::add_crossing(std::uint32_t a, std::uint32_t b) {
  const TriangleCorners &of_a = mesh_->triangles[a], &of_b = mesh_->triangles[b];
  const auto shared =
      std::count_if(of_b.begin(), of_b.end(), [&](Corner c) { return std::count(of_a.begin(), of_a.end(), c) > 0; });
  const Triangle ca = corners(a), cb = corners(b);
  if (is_in_plane(ca, cb) || is_in_plane(cb, ca)) {
    if (!is_overlapping(ca, cb)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      crossings_[a].push_back({cb[k], cb[(k + 1) % 3]});
      crossings_[b].push_back({ca[k], ca[(k + 1) % 3]});
    }
    return;
  }
  if (shared >= 2) return;
  std::vector<Vec3> points;
  add_piercings(ca, cb, points);
  add_piercings(cb, ca, points);
  Segment longest{Vec3::Zero(), Vec3::Zero()};
  for (const Vec3& x : points) {
    for (const Vec3& y : points) {
      if ((x - y).squaredNorm() > (longest[0] - longest[1]).squaredNorm()) longest = {x, y};
    }
  }
  if ((longest[0] - longest[1]).norm() <= kOn_mm) return;
  crossings_[a].push_back(longest);
  crossings_[b].push_back(longest);
}

double SolidDepth::at(const Vec3& point) const {
  if (!box_.contains(point) || is_outside(point)) return 0;
  std::vector<std::pair<double, std::uint32_t>> near;
  near.reserve(mesh_->triangles.size());
  for (std::uint32_t t = 0; t < mesh_->triangles.size(); ++t)
    near.emplace_back(std::sqrt(closest_on_triangle(point, corners(t)).distance2_mm2), t);
  std::sort(near.begin(), near.end());
  double depth = std::numeric_limits<double>::infinity();
  for (const auto& [distance, t] : near) {
    if (distance >= depth) break;
    if (!crossings_[t].empty()) {
      depth = std::min(depth, nearest_on_crossed(t, point, depth));
    } else if (has_outside_beside(t, (corners(t)[0] + corners(t)[1] + corners(t)[2]) / 3.0)) {
      depth = distance;
    }
  }
  return depth;
}

double SolidDepth::distance_to_surface(const Vec3& point) const {
  double nearest2_mm2 = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh_->triangles.size(); ++t)
    nearest2_mm2 = std::min(nearest2_mm2, closest_on_triangle(point, corners(t)).distance2_mm2);
  return std::sqrt(nearest2_mm2);
}

bool SolidDepth::is_outside(const Vec3& point) const { return std::abs(winding_number(*mesh_, point)) < 0.5; }

bool SolidDepth::has_outside_beside(std::uint32_t triangle, const Vec3& point) const {
  const Vec3 step = kBeside_mm * face_normal(*mesh_, triangle);
  return is_outside(point + step) || is_outside(point - step);
}

/// Returns whether the outside is next to the triangle near one of its points. Tests all directions in the plane of the
/// triangle.
bool SolidDepth::has_outside_around(std::uint32_t triangle, const Vec3& point) const {
  const Triangle own = corners(triangle);
  const Vec3 normal = face_normal(*mesh_, triangle);
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = (k + 0.5) * 2 * std::numbers::pi / kDirections;
    const Vec3 beside = point + kAround_mm * (std::cos(angle) * e1 + std::sin(angle) * e2);
    if (closest_on_triangle(beside, own).distance2_mm2 > kOn_mm * kOn_mm) continue;
    if (has_outside_beside(triangle, beside)) return true;
  }
  return false;
}

/// Returns the candidates for the nearest point of the boundary on a triangle. The boundary's part of the triangle is
/// bounded by the segments where the triangle meets others. So the nearest point is the foot of the point, a foot on a
/// segment, or a corner of a part.
std::vector<Vec3> SolidDepth::places_on(std::uint32_t triangle, const Vec3& point) const {
  const Triangle own = corners(triangle);
  std::vector<Segment> segments = crossings_[triangle];
  for (std::size_t k = 0; k < 3; ++k) segments.push_back({own[k], own[(k + 1) % 3]});
  std::vector<Vec3> places{closest_on_triangle(point, own).point};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    places.push_back(closest_on(segments[i], point));
    places.push_back(segments[i][0]);
    places.push_back(segments[i][1]);
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto crossing = crossing_of(segments[i], segments[j])) places.push_back(*crossing);
    }
  }
  std::erase_if(places,
                [&](const Vec3& place) { return closest_on_triangle(place, own).distance2_mm2 > kOn_mm * kOn_mm; });
  return places;
}

double SolidDepth::nearest_on_crossed(std::uint32_t triangle, const Vec3& point, double below_mm) const {
  std::vector<Vec3> places = places_on(triangle, point);
  const auto distance = [&](const Vec3& place) { return (place - point).squaredNorm(); };
  std::sort(places.begin(), places.end(), [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  for (const Vec3& place : places) {
    const double at = std::sqrt(distance(place));
    if (at >= below_mm) break;
    if (has_outside_around(triangle, place)) return at;
  }
  return below_mm;
}

}  // namespace gouge
