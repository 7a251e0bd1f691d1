#include "lib/overcut/swept_head.h"

#include <algorithm>

#include "lib/penetration/closest_point.h"

namespace gouge {

SweptHead::SweptHead(const Motion& motion, const HeadBody& head) : SweptSolid(motion), head_(head), moving_(motion) {
  for (const Vec3& v : head.surface.mesh.vertices) reach_mm_ = std::max(reach_mm_, v.norm());
}

double SweptHead::distance_at(const Vec3& point, double t) const {
  return closest_point(head_.surface, moving_.at(t).inverse().point(point))->signed_mm();
}

Vec3 SweptHead::outward_at(const Vec3& point, double t) const {
  const RigidTransform pose = moving_.at(t);
  return pose.direction(closest_point(head_.surface, pose.inverse().point(point))->normal);
}

}  // namespace gouge
