#include "toolmodels/draw_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"
#include "toolmodels/trace_regions.h"

namespace gouge::detail {
namespace {

constexpr Colour kBisector{70, 70, 78, 1};
constexpr Colour kContour{25, 28, 35, 1};
constexpr Colour kArrow{180, 40, 30, 1};
constexpr Colour kPaper{255, 255, 255, 1};

Colour region_colour(const BoundaryElement& e, const TracedRegion& region) {
  const double lighter = region.element % 4 < 2 ? 0 : 0.09;
  if (!region.is_inside)
    return lightened({120, 120, 128, 1}, e.kind == ElementKind::vertex ? 0.76 : 0.86 + lighter / 2);
  return lightened(body_colour(e.body), (e.kind == ElementKind::vertex ? 0.42 : 0.58) + lighter);
}

// Returns the part of a polygon on one side of a window's edge. Points beyond it move onto the edge.
std::vector<Vec2> clipped(const std::vector<Vec2>& points, int axis, double bound, double sign) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& p = points[i];
    const Vec2& q = points[(i + 1) % points.size()];
    const double vp = sign * (p[axis] - bound), vq = sign * (q[axis] - bound);
    if (vp >= 0) kept.push_back(p);
    if ((vp > 0 && vq < 0) || (vp < 0 && vq > 0)) kept.emplace_back(p + vp / (vp - vq) * (q - p));
  }
  return kept;
}

void fill_region(Drawing& drawing, const CompiledTool& tool, const TracedRegion& region, const ProfileView& view) {
  std::vector<Vec2> points = region.near_points;
  points.insert(points.end(), region.far_points.rbegin(), region.far_points.rend());
  for (const int axis : {0, 1}) {
    points = clipped(points, axis, view.low[axis], 1);
    points = clipped(points, axis, view.high[axis], -1);
  }
  if (points.size() < 3) return;
  for (Vec2& p : points) p = view.at(p);
  drawing.items.emplace_back(DrawnShape{std::move(points), region_colour(tool.elements[region.element], region)});
}

// Returns the part of the chord ab within the window, if any.
std::optional<std::pair<Vec2, Vec2>> clipped(const Vec2& a, const Vec2& b, const ProfileView& view) {
  double first = 0, last = 1;
  for (const int axis : {0, 1}) {
    const double run = b[axis] - a[axis];
    double enter = (view.low[axis] - a[axis]) / run, leave = (view.high[axis] - a[axis]) / run;
    if (std::abs(run) > 0) {
      if (enter > leave) std::swap(enter, leave);
      first = std::max(first, enter);
      last = std::min(last, leave);
    } else if (a[axis] < view.low[axis] || a[axis] > view.high[axis]) {
      return std::nullopt;
    }
  }
  if (first > last) return std::nullopt;
  return std::pair<Vec2, Vec2>(a + first * (b - a), a + last * (b - a));
}

// Draws a broken line within the window; `is_drawn` states for each point whether the line runs through it.
void draw_within(Drawing& drawing, const std::vector<Vec2>& points, const std::vector<bool>& is_drawn,
                 const ProfileView& view, const DrawnLine& style) {
  DrawnLine line = style;
  const auto flush = [&] {
    if (line.points.size() > 1) drawing.items.emplace_back(line);
    line.points.clear();
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto part = is_drawn[i] && is_drawn[i + 1] ? clipped(points[i], points[i + 1], view) : std::nullopt;
    if (!part) {
      flush();
      continue;
    }
    const Vec2 from = view.at(part->first);
    if (line.points.empty() || (line.points.back() - from).norm() > Tolerance::kNoSide) {
      flush();
      line.points.push_back(from);
    }
    line.points.push_back(view.at(part->second));
  }
  flush();
}

void outline_region(Drawing& drawing, const TracedRegion& region, const ProfileView& view) {
  draw_within(drawing, region.far_points, region.is_bisector, view, {{}, kBisector, 1.2, false, {}});
}

// Draws the normals at both ends of a region, where it borders on the regions of its neighbours along the contour.
void draw_seams(Drawing& drawing, const TracedRegion& region, const ProfileView& view) {
  for (const std::size_t i : {std::size_t{0}, region.near_points.size() - 1})
    draw_within(drawing, {region.near_points[i], region.far_points[i]}, {true, true}, view,
                {{}, kBisector, 0.8, false, {5, 4}});
}

}  // namespace

Colour body_colour(Body body) {
  if (body == Body::cutter) return {38, 101, 166, 1};
  if (body == Body::shank) return {46, 139, 98, 1};
  return {128, 96, 150, 1};
}

Colour lightened(const Colour& c, double amount) {
  const auto mix = [&](unsigned char v, unsigned char white) {
    return static_cast<unsigned char>(std::lround(v + amount * (white - v)));
  };
  return {mix(c.r, kPaper.r), mix(c.g, kPaper.g), mix(c.b, kPaper.b), c.opacity};
}

void draw_line(Drawing& drawing, const Vec2& from, const Vec2& to, const Colour& colour, double width,
               const std::vector<double>& dashes) {
  drawing.items.emplace_back(DrawnLine{{from, to}, colour, width, false, dashes});
}

void draw_text(Drawing& drawing, const Vec2& at, const std::string& text, double size, TextAnchor anchor,
               bool is_bold) {
  drawing.items.emplace_back(DrawnText{at, text, size, kContour, anchor, is_bold});
}

void draw_arrow(Drawing& drawing, const Vec2& from, const Vec2& to, const Colour& colour, double width) {
  const Vec2 along = (to - from).normalized();
  const Vec2 across(-along.y(), along.x());
  const double head = std::min(6.0 * width, (to - from).norm());
  draw_line(drawing, from, to - 0.8 * head * along, colour, width);
  drawing.items.emplace_back(
      DrawnShape{{to, to - head * along + 0.4 * head * across, to - head * along - 0.4 * head * across}, colour});
}

void draw_regions(Drawing& drawing, const CompiledTool& tool, const ProfileView& view, bool with_outside) {
  // The traced area is larger than the window, because an element outside the window may be the nearest one inside.
  const Vec2 margin = 2 * (view.high - view.low);
  const Vec2 low = view.low.cwiseMin(Vec2(0, tool.z_min_mm)) - margin;
  const Vec2 high = view.high.cwiseMax(Vec2(tool.r_max_mm, tool.z_max_mm)) + margin;
  std::vector<TracedRegion> regions = trace_regions(tool, low, high);
  if (!with_outside) std::erase_if(regions, [](const TracedRegion& r) { return !r.is_inside; });
  for (const TracedRegion& region : regions) fill_region(drawing, tool, region, view);
  for (const TracedRegion& region : regions) {
    outline_region(drawing, region, view);
    if (tool.elements[region.element].kind != ElementKind::segment) draw_seams(drawing, region, view);
  }
}

void draw_exit_arrows(Drawing& drawing, const CompiledTool& tool, const ProfileView& view, double spacing) {
  const double step = spacing / view.scale;
  for (double z = view.low.y() + 0.5 * step; z < view.high.y(); z += step)
    for (double r = 0.5 * step; r < view.high.x(); r += step) {
      const ToolDistance result = evaluate(tool, r, z);
      const double depth = -result.signed_distance_mm * view.scale;
      if (depth < 9) continue;
      const Vec2 from = view.at(Vec2(r, z));
      const Vec2 along(result.normal.x(), -result.normal.y());
      draw_arrow(drawing, from, from + std::min(0.62 * spacing, depth) * along, kArrow, 1.2);
    }
}

void draw_contour(Drawing& drawing, const Profile& profile, const ProfileView& view, double width) {
  std::vector<Vec2> points;
  for (const ProfileElement& e : profile.elements) {
    const std::vector<Vec2> part = sample(e, 96);
    points.insert(points.end(), part.begin(), part.end() - 1);
  }
  points.push_back(profile.elements.back().b);
  draw_within(drawing, points, std::vector<bool>(points.size(), true), view, {{}, kContour, width, false, {}});
}

}  // namespace gouge::detail
