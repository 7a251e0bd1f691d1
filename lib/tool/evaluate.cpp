#include "lib/tool/evaluate.h"

#include <cmath>

#include "lib/geom/vec.h"

namespace gouge {
namespace {

double node_value(const BspNode& node, double r, double z) {
  const double x = r - node.origin.x();
  const double y = z - node.origin.y();
  const double v = node.v0 + node.vx * x + node.vy * y;
  return v * (node.linear + node.square * v) + node.round * (x * x + y * y);
}

ToolDistance from_segment(const BoundaryElement& e, std::uint32_t index, const Vec2& q) {
  const double distance = e.normal.dot(q - e.a);
  return {distance, index, q - distance * e.normal, e.normal};
}

ToolDistance from_vertex(const BoundaryElement& e, std::uint32_t index, const Vec2& q) {
  const Vec2 away = q - e.a;
  const double distance = std::sqrt(away.squaredNorm());
  const double sign = e.is_reflex ? -1.0 : 1.0;
  const Vec2 normal = distance > 0 ? Vec2(away * (sign / distance)) : e.normal;
  return {sign * distance, index, e.a, normal};
}

// Returns the unit direction from the centre to the foot. Within rounding of the centre the BSP cannot distinguish the
// sectors of neighbouring elements. For a point just outside of its arc's sector, the foot is the nearer end. So the
// foot is always a point of the tool, and the normal is one of its normals.
Vec2 direction_to_closest(const BoundaryElement& e, const Vec2& away, double distance) {
  const Vec2 to_a = e.a - e.center;
  const Vec2 to_b = e.b - e.center;
  const double turn = e.is_reflex ? -1.0 : 1.0;
  if (turn * cross(to_a, away) >= 0 && turn * cross(away, to_b) >= 0) return away / distance;
  return (away.dot(to_a) > away.dot(to_b) ? to_a : to_b).normalized();
}

ToolDistance from_arc(const BoundaryElement& e, std::uint32_t index, const Vec2& q) {
  const Vec2 away = q - e.center;
  const double distance = std::sqrt(away.squaredNorm());
  const double sign = e.is_reflex ? -1.0 : 1.0;
  const Vec2 direction = distance > 0 ? direction_to_closest(e, away, distance) : e.normal;
  return {sign * (distance - e.radius_mm), index, e.center + e.radius_mm * direction, sign * direction};
}

ToolDistance result(const BoundaryElement& e, std::uint32_t index, const Vec2& q) {
  if (e.kind == ElementKind::segment) return from_segment(e, index, q);
  return e.kind == ElementKind::vertex ? from_vertex(e, index, q) : from_arc(e, index, q);
}

/// Returns the same distance as `result`, to the last bit.
double distance_of(const BoundaryElement& e, const Vec2& q) {
  if (e.kind == ElementKind::segment) return e.normal.dot(q - e.a);
  const bool is_vertex = e.kind == ElementKind::vertex;
  const double distance = std::sqrt((q - (is_vertex ? e.a : e.center)).squaredNorm());
  return (e.is_reflex ? -1.0 : 1.0) * (is_vertex ? distance : distance - e.radius_mm);
}

bool has_stretches_alone(const CompiledTool& tool) { return tool.nodes.empty() && tool.elements.size() > 1; }

std::uint32_t nearest_element(const CompiledTool& tool, double r, double z) {
  std::int32_t at = tool.nodes.empty() ? ~std::int32_t{0} : 0;
  while (at >= 0) {
    const BspNode& node = tool.nodes[static_cast<std::size_t>(at)];
    at = node_value(node, r, z) < 0 ? node.negative : node.positive;
  }
  return static_cast<std::uint32_t>(~at);
}

}  // namespace

ToolDistance evaluate(const CompiledTool& tool, double r_mm, double z_mm) {
  if (has_stretches_alone(tool)) return evaluate_by_stretches(tool, r_mm, z_mm);
  const std::uint32_t element = nearest_element(tool, r_mm, z_mm);
  return result(tool.elements[element], element, Vec2(r_mm, z_mm));
}

double signed_distance_mm(const CompiledTool& tool, double r_mm, double z_mm) {
  if (has_stretches_alone(tool)) return evaluate_by_stretches(tool, r_mm, z_mm).signed_distance_mm;
  return distance_of(tool.elements[nearest_element(tool, r_mm, z_mm)], Vec2(r_mm, z_mm));
}

ToolDistance evaluate_element(const CompiledTool& tool, std::uint32_t element, double r_mm, double z_mm) {
  return result(tool.elements[element], element, Vec2(r_mm, z_mm));
}

}  // namespace gouge
