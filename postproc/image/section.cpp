#include "postproc/image/section.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gouge {
namespace {

// Beyond this sine of its angle to the plane through the axis a direction would end off the outline in it.
constexpr double kInPlane = 0.05;

void cut_mesh(const IndexedMesh& mesh, const RigidTransform& to_part, const SectionPlane& plane, bool is_fixture,
              std::vector<SectionLine>& out) {
  const Vec3 normal = plane.pose.axis.cross(plane.u);
  // Points on the plane count as above it, so that every cut triangle has two cut sides.
  const auto height = [&](const Vec3& p) { return (p - plane.pose.tip).dot(normal) - plane.offset_mm; };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec2, 2> ends{Vec2::Zero(), Vec2::Zero()};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
      const Vec3 a = to_part.point(mesh.corner(t, k));
      const Vec3 b = to_part.point(mesh.corner(t, (k + 1) % 3));
      const double ha = height(a);
      const double hb = height(b);
      if ((ha >= 0) == (hb >= 0)) continue;
      ends[found++] = plane.flat(Vec3(a + (b - a) * (ha / (ha - hb))));
    }
    if (found == 2) out.push_back({ends[0], ends[1], is_fixture});
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

// The planes that a section may be cut in, through the point and along the axis.
std::vector<SectionPlane> planes(const Pose& pose, const Vec3& point_part, double size_mm,
                                 const std::optional<Vec3>& way_out) {
  const Vec3 d = point_part - pose.tip;
  const Vec3 across = d - pose.axis * d.dot(pose.axis);
  const bool is_on_axis = across.norm() < 1e-6 * size_mm;
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

// Liang and Barsky.
std::optional<std::array<Vec2, 2>> clipped(const Vec2& a, const Vec2& b, const Area& box) {
  double t0 = 0;
  double t1 = 1;
  const Vec2 d = b - a;
  const auto cut = [&](double p, double q) {  // keeps p t <= q
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

std::vector<SectionLine> cut_scene(const Scene& scene, const SectionPlane& plane) {
  std::vector<SectionLine> out;
  for (const IndexedMesh& mesh : scene.parts) cut_mesh(mesh, {}, plane, false, out);
  for (const IndexedMesh& mesh : scene.fixtures) cut_mesh(mesh, {}, plane, true, out);
  return out;
}

std::vector<std::vector<SectionLine>> cut_heads(std::span<const HeadBody> heads, const RigidTransform& to_part,
                                                const SectionPlane& plane) {
  std::vector<std::vector<SectionLine>> out(heads.size());
  for (std::size_t h = 0; h < heads.size(); ++h) cut_mesh(heads[h].surface.mesh(), to_part, plane, false, out[h]);
  return out;
}

Section make_section(const Scene& scene, const Pose& pose, const Vec3& point_part, double size_mm,
                     const std::optional<Vec3>& way_out) {
  Section best;
  double most = -1;
  for (const SectionPlane& plane : planes(pose, point_part, size_mm, way_out)) {
    for (const double side : {0.0, 1e-4, -1e-4}) {
      Section one{plane, {}, {}};
      one.plane.offset_mm += side * size_mm;
      one.lines = cut_scene(scene, one.plane);
      const double length = length_near(one.lines, one.plane.flat(point_part), size_mm);
      // The plane itself unless a hair beside it shows clearly more: it ran along a face.
      if (most >= 0 && length <= most + 0.2 * size_mm) continue;
      most = length;
      best = std::move(one);
    }
  }
  return best;
}

}  // namespace gouge
