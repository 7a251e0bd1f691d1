#include "toolmodels/draw_parts.h"

#include <algorithm>
#include <cmath>

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

void fill_region(Drawing& drawing, const CompiledTool& tool, const TracedRegion& region,
                 const ProfileView& view) {
  DrawnShape shape;
  shape.fill = region_colour(tool.elements[region.element], region);
  for (const Vec2& p : region.near_points) shape.points.push_back(view.at(p));
  for (auto p = region.far_points.rbegin(); p != region.far_points.rend(); ++p)
    shape.points.push_back(view.at(*p));
  drawing.items.emplace_back(std::move(shape));
}

void outline_region(Drawing& drawing, const TracedRegion& region, const ProfileView& view) {
  DrawnLine line;
  line.colour = kBisector;
  line.width = 1.2;
  const auto flush = [&] {
    if (line.points.size() > 1) drawing.items.emplace_back(line);
    line.points.clear();
  };
  for (std::size_t i = 0; i < region.far_points.size(); ++i) {
    if (region.is_bisector[i])
      line.points.push_back(view.at(region.far_points[i]));
    else
      flush();
  }
  flush();
}

// The normals at the ends of a region, where it meets its neighbour on the contour.
void draw_seams(Drawing& drawing, const TracedRegion& region, const ProfileView& view) {
  for (const std::size_t i : {std::size_t{0}, region.near_points.size() - 1})
    draw_line(drawing, view.at(region.near_points[i]), view.at(region.far_points[i]), kBisector, 0.8, {5, 4});
}

bool is_within(const Vec2& p, const ProfileView& view) {
  return p.x() >= view.low.x() && p.x() <= view.high.x() && p.y() >= view.low.y() && p.y() <= view.high.y();
}

// Pulls the end `b` of a chord that leaves the window back to its edge.
Vec2 to_edge(const Vec2& a, Vec2 b, const ProfileView& view) {
  for (int axis = 0; axis < 2; ++axis) {
    const double bound = std::clamp(b[axis], view.low[axis], view.high[axis]);
    const double run = b[axis] - a[axis];
    if (std::abs(b[axis] - bound) > 0 && std::abs(run) > 0) b = a + (bound - a[axis]) / run * (b - a);
  }
  return b;
}

}  // namespace

Colour body_colour(Body body) {
  switch (body) {
    case Body::cutter:
      return {38, 101, 166, 1};
    case Body::shank:
      return {46, 139, 98, 1};
    case Body::holder:
      break;
  }
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
  drawing.items.emplace_back(DrawnShape{
      {to, to - head * along + 0.4 * head * across, to - head * along - 0.4 * head * across}, colour});
}

void draw_regions(Drawing& drawing, const CompiledTool& tool, const ProfileView& view, bool with_outside) {
  std::vector<TracedRegion> regions = trace_regions(tool, view.low, view.high);
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
      const ToolAnswer answer = evaluate(tool, r, z);
      const double depth = -answer.signed_distance_mm * view.scale;
      if (depth < 9) continue;
      const Vec2 from = view.at(Vec2(r, z));
      const Vec2 along(answer.normal.x(), -answer.normal.y());
      draw_arrow(drawing, from, from + std::min(0.62 * spacing, depth) * along, kArrow, 1.2);
    }
}

void draw_contour(Drawing& drawing, const Profile& profile, const ProfileView& view, double width) {
  for (const ProfileElement& e : profile.elements) {
    const std::vector<Vec2> points = sample(e, 96);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const bool has_first = is_within(points[i], view), has_second = is_within(points[i + 1], view);
      if (!has_first && !has_second) continue;
      const Vec2 a = has_first ? points[i] : to_edge(points[i + 1], points[i], view);
      const Vec2 b = has_second ? points[i + 1] : to_edge(points[i], points[i + 1], view);
      draw_line(drawing, view.at(a), view.at(b), kContour, width);
    }
  }
}

}  // namespace gouge::detail
