#include "lib/overcut/swept_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/check/support_plane.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kToolRounding_mm = 1e-9;

/// The smallest distance of a stretch from the tool axis.
double smallest_radius(const Vec3& a, const Vec3& b) {
  const Vec2 from = a.head<2>(), side = b.head<2>() - from;
  const double length2 = side.squaredNorm();
  const double share = length2 > 0 ? std::clamp(-from.dot(side) / length2, 0.0, 1.0) : 0.0;
  return (from + share * side).norm();
}

/// A cell's centre on its chord during an interval, in tool coordinates.
struct Chord {
  Vec3 q0, q1;
  double bulge_mm = 0, radius_mm = 0;

  Chord(const ToolInterval& interval, const Vec3& centre, double radius)
      : q0(interval.f0.to_tool(centre)), q1(interval.f1.to_tool(centre)), radius_mm(radius) {
    if (interval.t1 > interval.t0) bulge_mm = interval.bulge_mm((centre - interval.tip_middle).norm() + radius);
  }
};

/// Points of the tool in the cell lie behind a plane that supports it. The directions of the plane at both ends differ
/// by the turn; their mean serves, with half the difference at the cell's rim added.
std::optional<DriftingHalfSpace> behind(const SupportPlane& plane, const Chord& chord, const ToolInterval& interval) {
  const double around = chord.radius_mm + chord.bulge_mm;
  const double z_lo = std::min(chord.q0.z(), chord.q1.z()) - around;
  const double z_hi = std::max(chord.q0.z(), chord.q1.z()) + around;
  const double r = plane.range.r_min_mm > 0 ? smallest_radius(chord.q0, chord.q1) - around : 0.0;
  if (!supports(plane, z_lo, z_hi, 0, r, 0)) return std::nullopt;
  const Vec3 n0 = interval.f0.rows.transpose() * plane.normal, n1 = interval.f1.rows.transpose() * plane.normal;
  const double d0 = plane.depth_mm(chord.q0), d1 = plane.depth_mm(chord.q1);
  return behind_plane(n0, n1, 0.5 * (d0 + d1), d1 - d0, chord.bulge_mm, chord.radius_mm);
}

/// The plane that touches the tool at the sample's foot; at a corner that only planes of some heights support, that of
/// the side which the sample is farther in front of.
std::optional<DriftingHalfSpace> behind(const CompiledTool& tool, const ToolSample& sample, const Chord& chord,
                                        const ToolInterval& interval) {
  const SupportPlane plane = support_plane(tool, sample);
  std::optional<DriftingHalfSpace> half = behind(plane, chord, interval);
  const std::uint32_t corner = sample.nearest.element;
  if (half || tool.elements[corner].kind != ElementKind::vertex) return half;
  double farthest = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t side : {corner - 1, corner + 1}) {
    if (side >= tool.elements.size() || tool.elements[side].kind != ElementKind::segment) continue;
    ToolSample beside = sample;
    beside.nearest.element = side;
    beside.nearest.normal = tool.elements[side].normal;
    const SupportPlane other = support_plane(tool, beside);
    const double in_front = -other.depth_mm(sample.q);
    if (in_front <= farthest) continue;
    if (const std::optional<DriftingHalfSpace> kept = behind(other, chord, interval)) {
      half = kept;
      farthest = in_front;
    }
  }
  return half;
}

}  // namespace

double SweptTool::distance_at(const Vec3& point, double t) const {
  return signed_distance_mm(tool_, motion().at(t), point);
}

Vec3 SweptTool::outward_at(const Vec3& point, double t) const {
  const Pose pose = motion().at(t);
  const Vec3 d = point - pose.tip;
  const double z = d.dot(pose.axis);
  const Vec3 across = d - z * pose.axis;
  const double r = across.norm();
  const Vec2 normal = evaluate(tool_, r, z).normal;
  const Vec3 radial = r > 0 ? Vec3(across / r) : pose.axis.unitOrthogonal();
  return (normal.x() * radial + normal.y() * pose.axis).normalized();
}

SweptBound SweptTool::bound(const Vec3& centre, double radius, std::uint32_t index) const {
  const ToolInterval& interval = intervals_[index];
  const Chord chord(interval, centre, radius);
  const double length = (chord.q1 - chord.q0).norm();
  const ToolSample middle = sample_tool(tool_, 0.5 * (chord.q0 + chord.q1));
  SweptBound bound;
  bound.distance_mm = middle.nearest.signed_distance_mm;
  bound.t = interval.middle();
  bound.path_length_mm = length + 2 * chord.bulge_mm;
  bound.can_halve = intervals_.can_halve(index);
  if (bound.distance_mm - 0.5 * length - chord.bulge_mm > radius + kToolRounding_mm) return bound;
  bound.is_reached = true;
  if (sharp_zones_) {
    const Vec2 q(middle.q.head<2>().norm(), middle.q.z());
    const double around = radius + 0.5 * length + chord.bulge_mm + kToolRounding_mm;
    bound.is_blunt = std::none_of(sharp_zones_->begin(), sharp_zones_->end(),
                                  [&](const Box2& zone) { return zone.squaredExteriorDistance(q) <= around * around; });
  }
  bound.half = behind(tool_, middle, chord, interval);
  return bound;
}

std::optional<DriftingHalfSpace> SweptTool::half_space(const Vec3& point, double s, const Vec3& centre, double radius,
                                                       std::uint32_t index) const {
  const ToolInterval& interval = intervals_[index];
  const Vec3 q = (0.5 - s) * interval.f0.to_tool(point) + (0.5 + s) * interval.f1.to_tool(point);
  return behind(tool_, sample_tool(tool_, q), Chord(interval, centre, radius), interval);
}

std::vector<Box3> SweptTool::extents(const Eigen::Matrix3d& frame, std::uint32_t index, bool is_sharp_only) const {
  if (!is_sharp_only || !sharp_zones_)
    return {extent(frame, index, Box2(Vec2(0, tool_.z_min_mm), Vec2(tool_.r_max_mm, tool_.z_max_mm)))};
  std::vector<Box3> boxes;
  for (const Box2& zone : *sharp_zones_) boxes.push_back(extent(frame, index, zone));
  return boxes;
}

/// Of the ring that a box of the half plane makes about the axis.
Box3 SweptTool::extent(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring) const {
  const ToolInterval& interval = intervals_[index];
  const double far = ring.max().x() + std::max(std::abs(ring.min().y()), std::abs(ring.max().y()));
  const double bulge = interval.t1 > interval.t0 ? interval.bulge_mm(far) : 0;
  Box3 box;
  for (const ToolFrame* at : {&interval.f0, &interval.f1}) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 direction = frame.row(k);
      const double along = at->rows.row(2).dot(direction);
      const double across = ring.max().x() * std::sqrt(std::max(0.0, 1 - along * along)) + bulge + kToolRounding_mm;
      const double tip = at->tip.dot(direction);
      const double a = tip + along * ring.min().y(), b = tip + along * ring.max().y();
      box.min()[k] = std::min(box.min()[k], std::min(a, b) - across);
      box.max()[k] = std::max(box.max()[k], std::max(a, b) + across);
    }
  }
  return box;
}

}  // namespace gouge
