#include "lib/tool/inscribed_balls.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kShrink = 0.97;  // factor for a ball that needs many steps; a smaller ball is good enough
constexpr int kMaxShrinks = 30, kQuickShrinks = 10;
constexpr std::size_t kMaxStretches = 100'000;  // beyond this number, a stretch that would be divided counts as having
                                                // no ball

/// Returns whether heights do not decrease along the element.
bool faces_outwards(const BoundaryElement& e) {
  if (e.kind == ElementKind::vertex) return true;
  if (e.kind == ElementKind::segment) return e.normal.x() >= -Tolerance::kExactDirection;
  const double out = e.is_reflex ? -1 : 1;
  return std::min(out * (e.a - e.center).x(), out * (e.b - e.center).x()) >= -Tolerance::kExactDirection * e.radius_mm;
}

/// Returns a box that contains the points of a cell that are at most `depth_mm` deep.
Box2 box_of(const FootCell& cell, double depth_mm) {
  const double t = std::min(depth_mm, cell.longest_ray_mm());
  Box2 box;
  for (const double s : {cell.from, cell.middle(), cell.to}) {
    box.extend(cell.at(s, 0));
    box.extend(cell.at(s, t));
  }
  // Distance of an arc from the two chords between these points.
  const double widest = std::max(std::abs(cell.radius_mm), std::abs(cell.radius_mm + cell.side * t));
  const double out = cell.is_straight() ? 0 : widest * (1 - std::cos(0.25 * (cell.to - cell.from)));
  const double margin = out + Tolerance::kRounding_mm;
  return Box2(Vec2(box.min().array() - margin), Vec2(box.max().array() + margin));
}

}  // namespace

InscribedBall inscribed_ball(const CompiledTool& tool, const FootCell& cell, double s, double min_mm,
                             double nearly_mm) {
  const double size = tool.r_max_mm + tool.z_max_mm - tool.z_min_mm;
  const Vec2 foot = cell.at(s, 0), inward = cell.inward_at(s);
  double t = std::min(cell.longest_ray_mm(), size);
  if (inward.x() < 0) t = std::min(t, foot.x() / -inward.x());
  for (int k = 0; k < kMaxShrinks && t > min_mm; ++k) {
    Vec2 center = foot + t * inward;
    if (center.x() < Tolerance::kConstruction * size) center.x() = 0;
    const ToolDistance at = evaluate(tool, center.x(), center.y());
    if (-at.signed_distance_mm >= t - nearly_mm) return {center, -at.signed_distance_mm};
    const Vec2 across = at.foot - foot;
    const double rise = across.dot(inward);
    const double touching = rise > 0 ? across.squaredNorm() / (2 * rise) : 0;
    t = (k < kQuickShrinks ? 1 : kShrink) * std::min(t, touching);
  }
  return {};
}

InscribedBalls::InscribedBalls(const CompiledTool& tool, double slack_mm)
    : slack_mm_(slack_mm), is_single_valued_(std::all_of(tool.elements.begin(), tool.elements.end(), faces_outwards)) {
  for (const FootCell& cell : foot_cells(tool)) cover(tool, cell);
}

void InscribedBalls::cover(const CompiledTool& tool, const FootCell& cell) {
  const InscribedBall ball = inscribed_ball(tool, cell, cell.middle(), slack_mm_, 0.25 * slack_mm_);
  // Consider the segment from a foot inward, as long as the radius. The distance from `ball.center` is largest at one of
  // its two ends.
  const bool has_ball =
      ball.radius_mm > 0 && cell.farthest_mm(ball.center, ball.radius_mm) <= ball.radius_mm + slack_mm_;
  if (has_ball || cell.width_mm(0) <= slack_mm_ || stretches_.size() >= kMaxStretches) {
    stretches_.push_back({cell, has_ball ? ball.radius_mm : 0});
    return;
  }
  FootCell half = cell;
  half.to = cell.middle();
  cover(tool, half);
  half.from = cell.middle();
  half.to = cell.to;
  cover(tool, half);
}

std::vector<Box2> InscribedBalls::sharp_zones(double depth_mm) const {
  std::vector<Box2> zones;
  bool is_open = false;
  for (const Stretch& stretch : stretches_) {
    const bool is_sharp = stretch.radius_mm < depth_mm;
    if (is_sharp && !is_open) zones.emplace_back();
    if (is_sharp) zones.back().extend(box_of(stretch.cell, depth_mm));
    is_open = is_sharp;
  }
  return zones;
}

}  // namespace gouge
