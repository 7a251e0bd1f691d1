#include "lib/overcut/swept_tool.h"

#include <algorithm>
#include <cmath>

#include "lib/tool/evaluate.h"

namespace gouge {

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

double SweptTool::reach_mm() const {
  const double height = std::max(std::abs(tool_.z_min_mm), std::abs(tool_.z_max_mm));
  return std::sqrt(tool_.r_max_mm * tool_.r_max_mm + height * height);
}

}  // namespace gouge
