#include "lib/overcut/swept_solid.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/overcut/ceiling.h"

namespace gouge {
namespace {

constexpr double kSteep = 0.1;  // share of the cell's size by which the surface may be higher than its closest point

}  // namespace

SweptHead::SweptHead(const Motion& motion, const HeadBody& head)
    : SweptSolid(motion), head_(head), moving_(motion), intervals_(moving_, motion), box_(head.box) {}

double SweptHead::distance_at(const Vec3& point, double t) const {
  return head_.surface.closest_point(moving_.at(t).inverse().point(point))->signed_mm();
}

Vec3 SweptHead::outward_at(const Vec3& point, double t) const {
  const RigidTransform pose = moving_.at(t);
  return pose.direction(head_.surface.closest_point(pose.inverse().point(point))->normal);
}

SweptBound SweptHead::bound(const Vec3& centre, double radius, std::uint32_t index) const {
  const BodyInterval& interval = intervals_[index];
  const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
  SweptBound bound;
  bound.t = interval.t0;
  bound.can_halve = intervals_.can_halve(index);
  const double d0 = head_.surface.closest_point(q0)->signed_mm();
  bound.distance_mm = d0;
  double least = d0;
  if (interval.t1 > interval.t0) {
    bound.path_length_mm = (q1 - q0).norm() + 2 * moving_.bulge_mm(interval, q0.norm());
    const double d1 = head_.surface.closest_point(q1)->signed_mm();
    least = 0.5 * (d0 + d1 - bound.path_length_mm);
    if (d1 < d0) {
      bound.distance_mm = d1;
      bound.t = interval.t1;
    }
  }
  bound.is_reached = least <= radius + Tolerance::kRounding_mm;
  if (bound.is_reached) bound.half = half_space(centre, 0, centre, radius, index);
  return bound;
}

std::optional<DriftingHalfSpace> SweptHead::half_space(const Vec3& point, double s, const Vec3& centre, double radius,
                                                       std::uint32_t index) const {
  const BodyInterval& interval = intervals_[index];
  const Vec3 near = (0.5 - s) * interval.to_tool0.point(point) + (0.5 + s) * interval.to_tool1.point(point);
  const auto foot = head_.surface.closest_point(near);
  const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
  const double bulge = moving_.bulge_mm(interval, q0.norm() + radius);
  const Vec3& up = foot->normal;
  const Vec3 chord = q1 - q0;
  const double along = up.dot(chord);
  const double around = radius + bulge + Tolerance::kRounding_mm;
  Column column;
  column.through = 0.5 * (q0 + q1);
  column.direction = up;
  column.radius_mm = around + 0.5 * (chord - along * up).norm();
  const double enough = up.dot(foot->point - column.through) + kSteep * radius + Tolerance::kRounding_mm;
  const auto height = ceiling(head_.surface, column, around + 0.5 * std::abs(along), enough, enough);
  if (!height) return std::nullopt;
  const Vec3 n0 = interval.to_tool0.rotation.transpose() * up, n1 = interval.to_tool1.rotation.transpose() * up;
  return behind_plane(n0, n1, *height, -along, bulge, radius);
}

std::vector<Box3> SweptHead::extents(const Eigen::Matrix3d& frame, std::uint32_t index, bool /*is_sharp_only*/) const {
  const BodyInterval& interval = intervals_[index];
  const double far = box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs()).norm();
  const double bulge = moving_.bulge_mm(interval, far);
  Box3 box;
  for (const RigidTransform* to_tool : {&interval.to_tool0, &interval.to_tool1}) {
    const RigidTransform to_part = to_tool->inverse();
    for (int corner = 0; corner < 8; ++corner)
      box.extend(Vec3(frame * to_part.point(box_.corner(static_cast<Box3::CornerType>(corner)))));
  }
  box.min().array() -= bulge + Tolerance::kRounding_mm;
  box.max().array() += bulge + Tolerance::kRounding_mm;
  return {box};
}

}  // namespace gouge
