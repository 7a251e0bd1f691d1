#include "lib/overcut/swept_solid.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/overcut/ceiling.h"

namespace gouge {
namespace {

constexpr double kSteep = 0.1;  // share of the cell's size by which the surface may be higher than its closest point
constexpr double kAlongFacet = 0.99;  // minimum cosine of the angle between the normal of a facet, whose plane is used,
                                      // and the direction to the closest point

}  // namespace

SweptHead::SweptHead(const Motion& motion, const HeadBody& head)
    : SweptSolid(motion), head_(head), moving_(motion), intervals_(moving_, motion), box_(head.box) {}

double SweptHead::distance_at(const Vec3& point, double t) const {
  return closest_to(moving_.at(t).inverse().point(point)).signed_mm();
}

Vec3 SweptHead::outward_at(const Vec3& point, double t) const {
  const RigidTransform pose = moving_.at(t);
  return pose.direction(closest_to(pose.inverse().point(point)).normal);
}

// Starts the search at the facet found before, because points that follow each other are often close. The direction is
// often asked at the point whose distance was asked before.
const ClosestPoint& SweptHead::closest_to(const Vec3& q) const {
  if (last_ && last_->of == q) return last_->foot;
  last_ = LastFoot{q, head_.surface.closest_point_from(q, last_ ? last_->foot.triangle : 0)};
  return last_->foot;
}

// Bounds the distance by the plane of the closest facet, which is exact to first order, if the whole head is below it.
SweptBound SweptHead::bound(const Vec3& centre, double radius, std::uint32_t index) const {
  const BodyInterval& interval = intervals_[index];
  const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
  const double bulge = moving_.bulge_mm(interval, q0.norm());
  SweptBound bound;
  bound.can_halve = intervals_.can_halve(index);
  bound.path_length_mm = (q1 - q0).norm() + 2 * bulge;
  const ClosestPoint foot = closest_to(0.5 * (q0 + q1));
  double d0 = foot.signed_mm(), d1 = d0;
  double least = d0 - 0.5 * bound.path_length_mm;
  if (const auto plane = plane_at(foot)) {
    d0 = plane->normal.dot(q0) - plane->height_mm;
    d1 = plane->normal.dot(q1) - plane->height_mm;
    least = std::max(least, std::min(d0, d1) - bulge);
  } else if (interval.t1 > interval.t0) {
    d0 = closest_to(q0).signed_mm();
    d1 = closest_to(q1).signed_mm();
    least = std::max(least, 0.5 * (d0 + d1 - bound.path_length_mm));
  }
  bound.distance_mm = std::min(d0, d1);
  bound.t = d1 < d0 ? interval.t1 : interval.t0;
  bound.is_reached = least <= radius + Tolerance::kRounding_mm;
  if (bound.is_reached) bound.half = half_space_at(foot, centre, radius, interval);
  return bound;
}

std::optional<DriftingHalfSpace> SweptHead::half_space(const Vec3& point, double s, const Vec3& centre, double radius,
                                                       std::uint32_t index) const {
  const BodyInterval& interval = intervals_[index];
  const Vec3 near = (0.5 - s) * interval.to_tool0.point(point) + (0.5 + s) * interval.to_tool1.point(point);
  return half_space_at(closest_to(near), centre, radius, interval);
}

/// Returns the plane of the closest facet if the whole head is below it and it is nearly square to the direction of the
/// foot.
std::optional<OuterPlane> SweptHead::plane_at(const ClosestPoint& foot) const {
  const bool is_along = head_.surface.face_normal(foot.triangle).dot(foot.normal) > kAlongFacet;
  return is_along ? head_.supports.plane(foot.triangle) : std::nullopt;
}

std::optional<DriftingHalfSpace> SweptHead::half_space_at(const ClosestPoint& foot, const Vec3& centre, double radius,
                                                          const BodyInterval& interval) const {
  const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
  const double bulge = moving_.bulge_mm(interval, q0.norm() + radius);
  const auto plane = plane_at(foot);
  Column column;
  column.through = 0.5 * (q0 + q1);
  column.direction = plane ? plane->normal : foot.normal;
  const Vec3& up = column.direction;
  const Vec3 chord = q1 - q0;
  const double along = up.dot(chord);
  std::optional<double> height;
  if (plane) {
    height = plane->height_mm - up.dot(column.through);
  } else {
    const double around = radius + bulge + Tolerance::kRounding_mm;
    column.radius_mm = around + 0.5 * (chord - along * up).norm();
    const double enough = up.dot(foot.point - column.through) + kSteep * radius + Tolerance::kRounding_mm;
    height = ceiling(head_.surface, column, around + 0.5 * std::abs(along), enough, enough);
  }
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
