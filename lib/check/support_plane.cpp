#include "lib/check/support_plane.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

// Returns the radial unit vector at q. On the axis every direction is possible; there it is x.
Vec3 radial(const Vec3& q, double r) { return r > 0 ? Vec3(q.x() / r, q.y() / r, 0) : Vec3::UnitX(); }

double radius(const Vec3& q) { return std::sqrt(q.x() * q.x() + q.y() * q.y()); }

constexpr std::size_t kMaxBesideFace = 256;  // maximum number of elements for which all are examined

/// Returns the largest radius of an element within the heights [z_lo, z_hi], which the element must reach; for an arc,
/// of the whole arc.
double widest_within(const BoundaryElement& e, double z_lo, double z_hi) {
  const double ends = std::max(e.a.x(), e.b.x());
  if (e.kind == ElementKind::arc) return e.is_reflex ? ends : std::max(ends, e.center.x() + e.radius_mm);
  const double rise = e.b.y() - e.a.y();
  if (!(std::abs(rise) > 0)) return ends;
  const auto radius_at = [&](double z) {
    return e.a.x() + std::clamp((z - e.a.y()) / rise, 0.0, 1.0) * (e.b.x() - e.a.x());
  };
  return std::max(radius_at(z_lo), radius_at(z_hi));
}

/// Returns whether an element is a horizontal face of the tool: all its closest points have the same height.
bool is_face(const BoundaryElement& e) {
  return e.kind == ElementKind::segment && !(e.a.y() < e.b.y()) && !(e.b.y() < e.a.y());
}

/// Returns whether a set from z_lo to z_hi stays outside of the tool's radius on the free side of a face. That holds if
/// the tool is at most `r` wide at every height from the face to the end of the set on that side.
bool is_free_of(const CompiledTool& tool, const BoundaryElement& face, double z_lo, double z_hi, double r) {
  if (tool.elements.size() > kMaxBesideFace) return false;
  const double z = face.a.y();
  const bool is_below = face.normal.y() < 0;
  const double low = is_below ? std::min(z_lo, z) : z, high = is_below ? z : std::max(z_hi, z);
  return std::ranges::all_of(tool.elements, [&](const BoundaryElement& e) {
    // An arc reaches higher or lower than its ends only if it has a pole.
    const bool has_pole = e.kind == ElementKind::arc && (e.a.x() < e.center.x()) != (e.b.x() < e.center.x());
    const double bottom = has_pole ? e.center.y() - e.radius_mm : std::min(e.a.y(), e.b.y());
    const double top = has_pole ? e.center.y() + e.radius_mm : std::max(e.a.y(), e.b.y());
    const bool is_beside = is_below ? bottom < high && top >= low : top > low && bottom <= high;
    return !is_beside || widest_within(e, low, high) <= r;
  });
}

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
  plane.element = nearest.element;
  // A direction that points to the axis by no more than kExactDirection does so by rounding.
  if (nearest.normal.x() >= -Tolerance::kExactDirection) plane.range = tool.elements[nearest.element].support;
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

bool supports(const CompiledTool& tool, const SupportPlane& plane, const SupportedSet& set, double margin_mm) {
  if (plane.range.z_lo_mm > plane.range.z_hi_mm) return false;
  const double shift = std::max(0.0, set.largest_depth_mm) * plane.normal.z();
  const double lowest = set.z_lo_mm + std::min(0.0, shift) - margin_mm;
  const double highest = set.z_hi_mm + std::max(0.0, shift) + margin_mm;
  const double r = set.smallest_r_mm - margin_mm;
  const bool is_in_range = lowest >= plane.range.z_lo_mm && highest <= plane.range.z_hi_mm &&
                           (plane.range.r_min_mm <= 0 || r >= plane.range.r_min_mm);
  if (is_in_range) return true;
  return is_face(tool.elements[plane.element]) &&
         is_free_of(tool, tool.elements[plane.element], set.z_lo_mm - margin_mm, set.z_hi_mm + margin_mm, r);
}

}  // namespace gouge
