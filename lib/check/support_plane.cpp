#include "lib/check/support_plane.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

// Radial unit vector at q; on the axis every direction serves, x is taken.
Vec3 radial(const Vec3& q, double r) { return r > 0 ? Vec3(q.x() / r, q.y() / r, 0) : Vec3::UnitX(); }

double radius(const Vec3& q) { return std::sqrt(q.x() * q.x() + q.y() * q.y()); }

}  // namespace

ToolSample sample_tool(const CompiledTool& tool, const Vec3& q_tool) {
  return {q_tool, evaluate(tool, radius(q_tool), q_tool.z())};
}

SupportPlane support_plane(const CompiledTool& tool, const ToolSample& sample) {
  const Vec3 out = radial(sample.q, radius(sample.q));
  const ToolDistance& nearest = sample.nearest;
  SupportPlane plane;
  plane.normal = nearest.normal.x() * out + nearest.normal.y() * Vec3::UnitZ();
  plane.foot = nearest.foot.x() * out + nearest.foot.y() * Vec3::UnitZ();
  plane.offset_mm = plane.normal.dot(plane.foot);
  plane.range = tool.elements[nearest.element].support;
  return plane;
}

SupportPlane mirrored(const SupportPlane& plane) {
  SupportPlane result = plane;
  result.normal.x() = -plane.normal.x();
  result.normal.y() = -plane.normal.y();
  result.foot.x() = -plane.foot.x();
  result.foot.y() = -plane.foot.y();
  return result;
}

bool supports(const SupportPlane& plane, double z_lo_mm, double z_hi_mm, double largest_depth_mm, double smallest_r_mm,
              double margin_mm) {
  const double shift = std::max(0.0, largest_depth_mm) * plane.normal.z();
  const double lowest = z_lo_mm + std::min(0.0, shift) - margin_mm;
  const double highest = z_hi_mm + std::max(0.0, shift) + margin_mm;
  if (lowest < plane.range.z_lo_mm || highest > plane.range.z_hi_mm) return false;
  return plane.range.r_min_mm <= 0 || smallest_r_mm - margin_mm >= plane.range.r_min_mm;
}

}  // namespace gouge
