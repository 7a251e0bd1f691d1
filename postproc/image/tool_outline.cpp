#include "postproc/image/tool_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr int kOutlineSides = 96;
constexpr double kArcStep = 0.06;  // in radians

void append_arc(std::vector<Vec2>& points, const BoundaryElement& e) {
  const Vec2 from = e.a - e.center;
  const Vec2 to = e.b - e.center;
  double sweep = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / kArcStep)));
  for (int k = 1; k < steps; ++k) {
    const double angle = sweep * k / steps;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    points.emplace_back(e.center + Vec2(c * from.x() - s * from.y(), s * from.x() + c * from.y()));
  }
  points.push_back(e.b);
}

// Returns points on the shorter arc about `centre` from `from` to `to`, which have the same distance from it.
std::vector<Vec2> arc_about(const Vec2& centre, const Vec2& from, const Vec2& to) {
  BoundaryElement arc;
  arc.center = centre;
  arc.a = centre + from;
  arc.b = centre + to;
  std::vector<Vec2> points{arc.a};
  append_arc(points, arc);
  return points;
}

// Returns the outward directions of an element at both of its ends.
std::array<Vec2, 2> outward(const BoundaryElement& e) {
  if (e.kind == ElementKind::segment) return {e.normal, e.normal};
  const double sign = e.is_reflex ? -1 : 1;
  return {Vec2(sign * (e.a - e.center).normalized()), Vec2(sign * (e.b - e.center).normalized())};
}

}  // namespace

std::vector<std::vector<Vec2>> outline_at(const CompiledTool& tool, double distance_mm) {
  constexpr double kInside = 1e-6;
  constexpr int kStepsOfSegment = 64;
  std::vector<std::vector<Vec2>> pieces;
  const auto add = [&](std::vector<Vec2> points) {
    // Beside reflex corners, pieces reach into the region that is nearer to another element.
    std::erase_if(points, [&](const Vec2& p) {
      return p.x() < 0 || signed_distance_mm(tool, p.x(), p.y()) < (1 - kInside) * distance_mm;
    });
    if (points.size() > 1) pieces.push_back(std::move(points));
  };
  std::optional<Vec2> before;
  for (const BoundaryElement& e : tool.elements) {
    if (e.kind == ElementKind::vertex) continue;
    const auto [at_a, at_b] = outward(e);
    if (before && before->dot(at_a) < 1 - kInside) add(arc_about(e.a, distance_mm * *before, distance_mm * at_a));
    if (e.kind == ElementKind::segment) {
      std::vector<Vec2> points;
      for (int k = 0; k <= kStepsOfSegment; ++k)
        points.emplace_back(e.a + (e.b - e.a) * k / kStepsOfSegment + distance_mm * at_a);
      add(std::move(points));
    } else {
      add(arc_about(e.center, e.a - e.center + distance_mm * at_a, e.b - e.center + distance_mm * at_b));
    }
    before = at_b;
  }
  return pieces;
}

std::vector<OutlineRun> tool_outline(const CompiledTool& tool) {
  std::vector<OutlineRun> runs;
  for (const BoundaryElement& e : tool.elements) {
    if (e.kind == ElementKind::vertex) continue;
    const bool is_joined = !runs.empty() && runs.back().body == e.body &&
                           (runs.back().points.back() - e.a).norm() < Tolerance::kSamePoint_mm;
    if (!is_joined) runs.push_back({e.body, {e.a}});
    if (e.kind == ElementKind::arc)
      append_arc(runs.back().points, e);
    else
      runs.back().points.push_back(e.b);
  }
  return runs;
}

BodyRange body_range(const CompiledTool& tool, Body body) {
  BodyRange range{tool.z_max_mm + 1, tool.z_min_mm - 1};
  for (const OutlineRun& run : tool_outline(tool)) {
    if (run.body != body) continue;
    for (const Vec2& p : run.points) {
      range.low_mm = std::min(range.low_mm, p.y());
      range.high_mm = std::max(range.high_mm, p.y());
    }
  }
  return range;
}

ToolSurface tool_surface(const CompiledTool& tool, const Pose& pose) {
  ToolSurface surface;
  const Vec3 side = std::abs(pose.axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 e1 = pose.axis.cross(side).normalized();
  const Vec3 e2 = pose.axis.cross(e1);
  for (const OutlineRun& run : tool_outline(tool)) {
    const auto base = static_cast<std::uint32_t>(surface.vertices.size());
    for (const Vec2& p : run.points) {
      for (int k = 0; k < kOutlineSides; ++k) {
        const double angle = 2 * std::numbers::pi * k / kOutlineSides;
        surface.vertices.emplace_back(pose.tip + pose.axis * p.y() +
                                      p.x() * (std::cos(angle) * e1 + std::sin(angle) * e2));
      }
    }
    for (std::uint32_t ring = 0; ring + 1 < run.points.size(); ++ring) {
      for (std::uint32_t k = 0; k < kOutlineSides; ++k) {
        const std::uint32_t a = base + ring * kOutlineSides + k;
        const std::uint32_t b = base + ring * kOutlineSides + (k + 1) % kOutlineSides;
        surface.faces.push_back({a, b, b + kOutlineSides});
        surface.faces.push_back({a, b + kOutlineSides, a + kOutlineSides});
        surface.bodies.insert(surface.bodies.end(), 2, run.body);
      }
    }
  }
  return surface;
}

}  // namespace gouge
