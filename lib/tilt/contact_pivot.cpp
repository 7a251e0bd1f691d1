#include "lib/tilt/contact_pivot.h"

#include <algorithm>

#include "lib/geom/cross.h"

namespace gouge {
namespace {

constexpr double kAsFar = 1e-9;     // of the size of the tool: points this close in a direction are equally far in it
constexpr double kParallel = 1e-7;  // a direction that leads away from the axis by less has no side

/// A direction as seen from a tool axis.
struct Split {
  double along = 0, away = 0;
  Vec3 outward = Vec3::Zero();  ///< unit, across the axis; zero where the direction is that of the axis

  Split(const Vec3& direction, const Vec3& axis) : along(direction.dot(axis)) {
    const Vec3 across = direction - along * axis;
    if (across.norm() < kParallel) return;
    away = across.norm();
    outward = across / away;
  }
};

Vec2 nearest_on(const SupportStretch& stretch, const Vec2& point) {
  const Vec2 along = stretch.b - stretch.a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp(along.dot(point - stretch.a) / length2, 0.0, 1.0) : 0.0;
  return stretch.a + share * along;
}

}  // namespace

SupportStretch support_stretch(const CompiledTool& tool, const Vec2& direction) {
  const Vec2 unit = direction.normalized();
  const Vec2 across(-unit.y(), unit.x());
  const double slack = kAsFar * (tool.z_max_mm - tool.z_min_mm + tool.r_max_mm);
  SupportStretch best{tool.elements.front().a, tool.elements.front().a};
  double farthest = unit.dot(best.a);
  const auto offer = [&](const Vec2& point) {
    const double far = unit.dot(point);
    if (far < farthest - slack) return;
    if (far > farthest + slack) best = {point, point};
    farthest = std::max(far, farthest);
    if (across.dot(point) < across.dot(best.a)) best.a = point;
    if (across.dot(point) > across.dot(best.b)) best.b = point;
  };
  for (const BoundaryElement& e : tool.elements) {
    offer(e.a);
    offer(e.b);
    if (e.kind != ElementKind::arc || e.is_reflex) continue;
    if (cross(e.a - e.center, unit) >= 0 && cross(unit, e.b - e.center) >= 0) offer(e.center + e.radius_mm * unit);
  }
  return best;
}

ContactPivot::ContactPivot(const Pose& programmed, const CompiledTool& cutter, const Vec3& normal)
    : programmed_(programmed), cutter_(&cutter), normal_(normal) {
  const Split before(-normal, programmed.axis);
  touched_ = support_stretch(cutter, {before.away, before.along});
}

Vec3 ContactPivot::tip_for(const Vec3& axis) const {
  if (cutter_ == nullptr) return programmed_.tip;
  const Split now(-normal_, axis), before(-normal_, programmed_.axis);
  const SupportStretch touching = support_stretch(*cutter_, {now.away, now.along});
  const Vec2 was = nearest_on(touched_, 0.5 * (touching.a + touching.b));
  const Vec2 is = nearest_on(touching, was);
  // A face that is square to the axis touches all around it: there the contact is on the side of the other one.
  const Vec3 side_was = before.away > 0 ? before.outward : Split(now.outward, programmed_.axis).outward;
  const Vec3 side_is = now.away > 0 ? now.outward : Split(before.outward, axis).outward;
  return programmed_.tip + was.x() * side_was + was.y() * programmed_.axis - is.x() * side_is - is.y() * axis;
}

}  // namespace gouge
