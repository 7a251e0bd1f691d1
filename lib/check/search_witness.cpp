#include "lib/check/search_witness.h"

namespace gouge {

ToolPoint locate(const Motion& motion, const SearchResult& found) {
  ToolPoint point;
  point.pose = motion.at(found.t);
  const Vec3 from_tip = found.point - point.pose.tip;
  point.z = from_tip.dot(point.pose.axis);
  const Vec3 across = from_tip - point.z * point.pose.axis;
  point.r = across.norm();
  point.out = point.r > 0 ? Vec3(across / point.r) : point.pose.axis.unitOrthogonal();
  return point;
}

Witness make_witness(const Motion& motion, const SearchResult& found, const SearchTarget& target,
                     const ToolPoint& point, const ToolDistance& at) {
  Witness witness;
  witness.t = found.t;
  witness.turn = motion.shares_at(found.t);
  witness.point = found.point;
  witness.normal = -(at.normal.x() * point.out + at.normal.y() * point.pose.axis).normalized();
  witness.body = target.tool->elements[at.element].body;
  witness.against = target.against;
  witness.mesh = target.first_mesh + static_cast<std::uint32_t>(target.tree->mesh_of(found.at.triangle));
  witness.triangle = target.tree->file_triangle(found.at.triangle);
  return witness;
}

}  // namespace gouge
