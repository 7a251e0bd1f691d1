#include "lib/stock/stock_head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

// Cylinders of a stack, and heights at which the mesh is cut before neighbours are joined.
constexpr std::size_t kMaxCylinders = 12, kMaxHeights = 48;
constexpr double kMinRadius = 1e-3;  // share of the widest radius, for heights without a triangle

struct Cylinder {
  double z_lo_mm = 0, z_hi_mm = 0, r_mm = 0;
  [[nodiscard]] double volume() const { return (z_hi_mm - z_lo_mm) * r_mm * r_mm; }
};

Cylinder joined(const Cylinder& below, const Cylinder& above) {
  return {below.z_lo_mm, above.z_hi_mm, std::max(below.r_mm, above.r_mm)};
}

/// Returns some heights of vertices in increasing order, the lowest and the highest among them.
std::vector<double> heights_of(const IndexedMesh& mesh) {
  std::vector<double> all;
  for (const Vec3& vertex : mesh.vertices) all.push_back(vertex.z());
  std::sort(all.begin(), all.end());
  const auto is_same = [](double a, double b) { return b - a <= Tolerance::kRounding_mm; };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
  if (all.size() <= kMaxHeights) return all;
  std::vector<double> some;
  for (std::size_t k = 0; k < kMaxHeights; ++k) some.push_back(all[k * (all.size() - 1) / (kMaxHeights - 1)]);
  return some;
}

/// Widens the cylinders whose heights a triangle enters. The section of a solid at any height between two of them is bounded
/// by triangles that cross this height. The distance from the axis is a convex function of the point, so it is largest at
/// a corner of what a triangle has between the heights.
void widen(const std::array<Vec3, 3>& corners, std::vector<Cylinder>& stack) {
  const auto [low, high] = std::minmax({corners[0].z(), corners[1].z(), corners[2].z()});
  for (Cylinder& one : stack) {
    if (high <= one.z_lo_mm || low >= one.z_hi_mm) continue;
    const auto take = [&](const Vec3& at) { one.r_mm = std::max(one.r_mm, at.head<2>().norm()); };
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const Vec3 &from = corners[c], &to = corners[(c + 1) % corners.size()];
      if (from.z() >= one.z_lo_mm && from.z() <= one.z_hi_mm) take(from);
      for (const double z : {one.z_lo_mm, one.z_hi_mm}) {
        if ((from.z() < z) == (to.z() < z) || !(std::abs(to.z() - from.z()) > 0)) continue;
        take(from + (z - from.z()) / (to.z() - from.z()) * (to - from));
      }
    }
  }
}

/// Joins the two neighbours that grow least, until there are few.
void join_neighbours(std::vector<Cylinder>& stack) {
  while (stack.size() > 1) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k + 1 < stack.size(); ++k) {
      const double more = joined(stack[k], stack[k + 1]).volume() - stack[k].volume() - stack[k + 1].volume();
      if (more < least) least = more, best = k;
    }
    const bool is_free = !(least > Tolerance::kRounding_mm);
    if (!is_free && stack.size() <= kMaxCylinders) return;
    stack[best] = joined(stack[best], stack[best + 1]);
    stack.erase(stack.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  }
}

std::vector<Cylinder> stack_around(const IndexedMesh& mesh) {
  const std::vector<double> heights = heights_of(mesh);
  std::vector<Cylinder> stack;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) stack.push_back({heights[k], heights[k + 1], 0});
  if (stack.empty()) return stack;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    widen({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, stack);
  double widest = 0;
  for (const Cylinder& one : stack) widest = std::max(widest, one.r_mm);
  for (Cylinder& one : stack) one.r_mm = std::max(one.r_mm, kMinRadius * widest) + Tolerance::kSamePoint_mm;
  join_neighbours(stack);
  stack.front().z_lo_mm -= Tolerance::kSamePoint_mm;
  stack.back().z_hi_mm += Tolerance::kSamePoint_mm;
  return stack;
}

/// Returns cylinders that contain these moved out in all directions. At every height the radius is the largest within that
/// distance.
std::vector<Cylinder> grown(const std::vector<Cylinder>& stack, double by_mm) {
  std::vector<double> heights;
  for (const Cylinder& one : stack)
    for (const double z : {one.z_lo_mm - by_mm, one.z_lo_mm + by_mm, one.z_hi_mm - by_mm, one.z_hi_mm + by_mm})
      heights.push_back(z);
  std::sort(heights.begin(), heights.end());
  std::vector<Cylinder> all;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    Cylinder next{heights[k], heights[k + 1], 0};
    for (const Cylinder& one : stack) {
      const bool is_near = one.z_lo_mm - by_mm < next.z_hi_mm && one.z_hi_mm + by_mm > next.z_lo_mm;
      if (is_near) next.r_mm = std::max(next.r_mm, one.r_mm + by_mm);
    }
    if (next.z_hi_mm > next.z_lo_mm) all.push_back(next);
  }
  join_neighbours(all);
  return all;
}

/// Appends a straight element that ends at `to`. The solid is on its left.
void add_line(const Vec2& to, Vec2& at, CompiledTool& tool) {
  const Vec2 way = to - at;
  if (!(way.norm() > 0)) return;
  BoundaryElement line;
  line.body = Body::head;
  line.a = at;
  line.b = to;
  line.normal = Vec2(way.y(), -way.x()).normalized();
  tool.elements.push_back(line);
  at = to;
}

}  // namespace

CompiledTool cylinders_around(const IndexedMesh& mesh, double grow_mm) {
  std::vector<Cylinder> stack = stack_around(mesh);
  CompiledTool tool;
  tool.name = mesh.name;
  if (stack.empty()) return tool;
  if (grow_mm > 0) stack = grown(stack, grow_mm);
  tool.z_min_mm = stack.front().z_lo_mm;
  tool.z_max_mm = stack.back().z_hi_mm;
  Vec2 at(0, tool.z_min_mm);
  for (const Cylinder& one : stack) {
    tool.r_max_mm = std::max(tool.r_max_mm, one.r_mm);
    add_line({one.r_mm, one.z_lo_mm}, at, tool);
    add_line({one.r_mm, one.z_hi_mm}, at, tool);
  }
  add_line({0, tool.z_max_mm}, at, tool);
  return tool;
}

StockHead::StockHead(const Surface& boundary, double grow_mm)
    : surface_(boundary),
      grow_mm_(grow_mm),
      solid_(StockSolid::solid(boundary)),
      around_(cylinders_around(boundary.mesh(), grow_mm)) {
  for (const BodyHulls& body : contour_hulls(around_))
    hulls_.insert(hulls_.end(), body.hulls.begin(), body.hulls.end());
  cylinder_ = {around_.r_max_mm, around_.z_min_mm, around_.z_max_mm};
  reach_mm_ = Vec2(around_.r_max_mm, std::max(std::abs(around_.z_min_mm), std::abs(around_.z_max_mm))).norm();
}

}  // namespace gouge
