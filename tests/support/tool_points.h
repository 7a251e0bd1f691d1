#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/tool/evaluate.h"
#include "tests/support/scatter.h"

// Points of the half plane at which results for a tool are most likely to be wrong.

namespace gouge::test {

inline double extent_mm(const CompiledTool& tool) { return std::max({tool.r_max_mm, tool.z_max_mm, -tool.z_min_mm}); }

inline Vec2 in_half_plane(const Vec2& p) { return {std::abs(p.x()), p.y()}; }

/// Returns a point between two points with different leaves, as near to the border of their regions as doubles allow.
inline Vec2 on_bisector(const CompiledTool& tool, Vec2 p, Vec2 q) {
  const std::uint32_t mine = evaluate(tool, p.x(), p.y()).element;
  if (evaluate(tool, q.x(), q.y()).element == mine) return p;
  for (int i = 0; i < 60; ++i) {
    const Vec2 middle = 0.5 * (p + q);
    if (middle == p || middle == q) break;
    (evaluate(tool, middle.x(), middle.y()).element == mine ? p : q) = middle;
  }
  return p;
}

/// Returns a point around the tool, far away, on the axis, or at any scale about the boundary and its corners. Others
/// are points along the normal at the middle of an element, also behind a tiny step, and points on bisectors.
inline Vec2 random_tool_point(Scatter& random, const CompiledTool& tool) {
  const double size = extent_mm(tool);
  const auto around = [&] {
    return Vec2{random.in(0, 1.5 * tool.r_max_mm), random.in(tool.z_min_mm - 0.3 * size, tool.z_max_mm + 0.3 * size)};
  };
  const BoundaryElement& e = tool.elements[random.next() % tool.elements.size()];
  const double distance = size * std::pow(10.0, random.in(-13, 1.5));
  const auto offset = [&]() -> Vec2 { return distance * Vec2{random.in(-1, 1), random.in(-1, 1)}; };
  switch (random.next() % 16) {
    case 0:
      return {0, random.in(tool.z_min_mm - size, tool.z_max_mm + size)};
    case 1:
      return {random.in(0, 50 * size), random.in(-50 * size, 50 * size)};
    case 2:
    case 3:
    case 4: {
      const double t = std::clamp(random.in(-0.5, 1.5), 0.0, 1.0);
      return in_half_plane(e.a + t * (e.b - e.a) + offset());
    }
    case 5:
      return in_half_plane(0.5 * (e.a + e.b) + (random.next() % 2 == 0 ? distance : -distance) * e.normal);
    case 6:
      return in_half_plane(e.center + offset());
    case 7: {
      const Vec2 p = around();
      return on_bisector(tool, p, in_half_plane(p + offset()));
    }
    default:
      return around();
  }
}

}  // namespace gouge::test
