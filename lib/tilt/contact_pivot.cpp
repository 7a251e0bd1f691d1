#include "lib/tilt/contact_pivot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"

namespace gouge {
namespace {

/// A direction as seen from a tool axis.
struct Split {
  double along = 0, away = 0;
  Vec3 outward = Vec3::Zero();  ///< unit, square to the axis; zero for a direction along the axis

  Split(const Vec3& direction, const Vec3& axis) : along(direction.dot(axis)) {
    const Vec3 across = direction - along * axis;
    if (across.norm() < Tolerance::kTangent) return;
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
  const double slack = Tolerance::kRounding * (tool.z_max_mm - tool.z_min_mm + tool.r_max_mm);
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

ContactPivot::ContactPivot(const Pose& programmed, const CompiledTool& cutter, std::vector<Vec3> normals)
    : programmed_(programmed), cutter_(&cutter) {
  std::ranges::stable_sort(normals, std::greater<>(), [&](const Vec3& normal) { return normal.dot(programmed.axis); });
  for (const Vec3& normal : normals) {
    const Split before(-normal, programmed.axis);
    contacts_.push_back({normal, support_stretch(cutter, {before.away, before.along})});
  }
  const auto lowest = std::ranges::find_if(cutter.elements, [](const BoundaryElement& e) {
    return e.kind != ElementKind::vertex && e.body == Body::cutter;
  });
  if (lowest == cutter.elements.end() || lowest->kind != ElementKind::arc || lowest->is_reflex) return;
  const double slack = Tolerance::kRounding * lowest->radius_mm;
  if (std::abs(lowest->center.x()) <= slack && lowest->center.y() > 0) ball_mm_ = lowest->center.y();
}

Vec3 ContactPivot::kept_at(const Contact& contact, const Vec3& axis) const {
  const Split now(-contact.normal, axis), before(-contact.normal, programmed_.axis);
  const SupportStretch touching = support_stretch(*cutter_, {now.away, now.along});
  const Vec2 was = nearest_on(contact.touched, 0.5 * (touching.a + touching.b));
  const Vec2 is = nearest_on(touching, was);
  // A face square to the axis touches the tool all around the axis. The contact is then on the side given by the other
  // axis.
  const Vec3 side_was = before.away > 0 ? before.outward : Split(now.outward, programmed_.axis).outward;
  const Vec3 side_is = now.away > 0 ? now.outward : Split(before.outward, axis).outward;
  return programmed_.tip + was.x() * side_was + was.y() * programmed_.axis - is.x() * side_is - is.y() * axis;
}

double ContactPivot::reach(const Contact& contact, const Pose& pose) const {
  const Split into(-contact.normal, pose.axis);
  const Vec2 direction(into.away, into.along);
  return direction.dot(support_stretch(*cutter_, direction).a) - contact.normal.dot(pose.tip);
}

Vec3 ContactPivot::tip_for(const Vec3& axis) const {
  if (ball_mm_ > 0) return programmed_.tip + ball_mm_ * (programmed_.axis - axis);
  if (contacts_.empty()) return programmed_.tip;
  constexpr int kRounds = 4;
  Pose pose{kept_at(contacts_.front(), axis), axis};
  for (int round = 0; round < kRounds && contacts_.size() > 1; ++round) {
    for (const Contact& contact : contacts_)
      pose.tip += std::max(0.0, reach(contact, pose) - reach(contact, programmed_)) * contact.normal;
  }
  return pose.tip;
}

}  // namespace gouge
