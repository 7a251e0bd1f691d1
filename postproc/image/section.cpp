#include "postproc/image/section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/triangles_within.h"

namespace gouge {
namespace {

// Maximum sine of the angle between a direction and the plane through the axis. For a larger angle, the direction would
// not end on the outline in this plane.
constexpr double kInPlane = 0.05;
constexpr double kBeside = 1e-4;  // relative to the size: distance of planes beside one that runs along faces

Vec3 normal_of(const SectionPlane& plane) { return plane.pose.axis.cross(plane.u); }

std::optional<SectionLine> cut_triangle(const std::array<Vec3, 3>& corners, const SectionPlane& plane) {
  const Vec3 normal = normal_of(plane);
  // Points on the plane count as above it, so that every triangle that is cut has two cut sides.
  const auto height = [&](const Vec3& p) { return (p - plane.pose.tip).dot(normal) - plane.offset_mm; };
  std::array<Vec2, 2> ends{Vec2::Zero(), Vec2::Zero()};
  std::size_t found = 0;
  for (std::size_t k = 0; k < 3 && found < 2; ++k) {
    const Vec3& a = corners[k];
    const Vec3& b = corners[(k + 1) % 3];
    const double ha = height(a);
    const double hb = height(b);
    if ((ha >= 0) == (hb >= 0)) continue;
    ends[found++] = plane.flat(Vec3(a + (b - a) * (ha / (ha - hb))));
  }
  if (found < 2) return std::nullopt;
  return SectionLine{ends[0], ends[1], false};
}

void cut_tree(const BlockTree& tree, const SectionPlane& plane, bool is_fixture, std::vector<SectionLine>& out) {
  const Vec3 normal = normal_of(plane);
  const double height = normal.dot(plane.pose.tip) + plane.offset_mm;
  const std::array<HalfSpace, 2> both{{{normal, height}, {-normal, -height}}};
  for (const std::uint32_t triangle : triangles_within(tree, both)) {
    if (auto line = cut_triangle(tree.corners(triangle), plane)) {
      line->is_fixture = is_fixture;
      out.push_back(*line);
    }
  }
}

double length_near(const std::vector<SectionLine>& lines, const Vec2& at, double reach) {
  double length = 0;
  const Area box{at.x() - reach, at.y() - reach, 2 * reach, 2 * reach};
  for (const SectionLine& line : lines) {
    if (const auto seen = clipped(line.a, line.b, box)) length += ((*seen)[1] - (*seen)[0]).norm();
  }
  return length;
}

std::vector<Vec3> around(const Vec3& axis) {
  const Vec3 e1 = axis.cross(std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
  const Vec3 e2 = axis.cross(e1);
  return {e1, e2, e1 + e2, e1 - e2};
}

// Returns the possible planes of a section, through the point and along the axis.
std::vector<SectionPlane> planes(const Pose& pose, const Vec3& point_part, double size_mm,
                                 const std::optional<Vec3>& way_out) {
  const Vec3 d = point_part - pose.tip;
  const Vec3 across = d - pose.axis * d.dot(pose.axis);
  const bool is_on_axis = across.norm() < Tolerance::kNoSide * size_mm;
  const Vec3 u = is_on_axis ? pose.axis : Vec3(across.normalized());
  const Vec3 aside = way_out ? Vec3(*way_out - pose.axis * way_out->dot(pose.axis)) : Vec3(Vec3::Zero());
  if (aside.norm() > kInPlane && (is_on_axis || std::abs(aside.dot(pose.axis.cross(u))) > kInPlane)) {
    const Vec3 along = (aside.dot(across) < 0 ? -1.0 : 1.0) * aside.normalized();
    const double beside = d.dot(pose.axis.cross(along));
    return {{pose, along, beside, beside}};
  }
  if (!is_on_axis) return {{pose, u, 0, 0}};
  std::vector<SectionPlane> open;
  for (const Vec3& direction : around(pose.axis)) open.push_back({pose, direction.normalized(), 0, 0});
  return open;
}

}  // namespace

// Clips the line a b at the box by the algorithm of Liang and Barsky; empty if it is outside.
std::optional<std::array<Vec2, 2>> clipped(const Vec2& a, const Vec2& b, const Area& box) {
  double t0 = 0;
  double t1 = 1;
  const Vec2 d = b - a;
  const auto cut = [&](double p, double q) {  // keeps the part with p t <= q
    if (p < 0)
      t0 = std::max(t0, q / p);
    else if (p > 0)
      t1 = std::min(t1, q / p);
    else
      return q >= 0;
    return t0 <= t1;
  };
  const bool is_seen = cut(-d.x(), a.x() - box.x) && cut(d.x(), box.right() - a.x()) && cut(-d.y(), a.y() - box.y) &&
                       cut(d.y(), box.bottom() - a.y());
  if (!is_seen || t0 > t1) return std::nullopt;
  return std::array<Vec2, 2>{Vec2(a + t0 * d), Vec2(a + t1 * d)};
}

std::vector<SectionLine> cut_scene(const PreparedScene& scene, const SectionPlane& plane) {
  std::vector<SectionLine> out;
  for (const PreparedObstacle& obstacle : scene.obstacles())
    cut_tree(obstacle.tree, plane, !obstacle.rule.is_workpiece, out);
  return out;
}

std::vector<std::vector<SectionLine>> cut_heads(std::span<const HeadBody> heads, const RigidTransform& to_part,
                                                const SectionPlane& plane) {
  std::vector<std::vector<SectionLine>> out(heads.size());
  for (std::size_t h = 0; h < heads.size(); ++h) {
    const Surface& surface = heads[h].surface;
    for (std::size_t t = 0; t < surface.mesh().triangles.size(); ++t) {
      std::array<Vec3, 3> corners = surface.corners(t);
      for (Vec3& corner : corners) corner = to_part.point(corner);
      if (const auto line = cut_triangle(corners, plane)) out[h].push_back(*line);
    }
  }
  return out;
}

Section make_section(const PreparedScene& scene, const Pose& pose, const Vec3& point_part, double size_mm,
                     const std::optional<Vec3>& way_out) {
  Section best;
  double most = -1;
  for (const SectionPlane& plane : planes(pose, point_part, size_mm, way_out)) {
    for (const double side : {0.0, kBeside, -kBeside}) {
      Section one{plane, {}, {}};
      one.plane.offset_mm += side * size_mm;
      one.lines = cut_scene(scene, one.plane);
      const double length = length_near(one.lines, one.plane.flat(point_part), size_mm);
      // The plane itself is used, unless one close beside it shows clearly more. Then the plane ran along a face.
      if (most >= 0 && length <= most + 0.2 * size_mm) continue;
      most = length;
      best = std::move(one);
    }
  }
  return best;
}

}  // namespace gouge
