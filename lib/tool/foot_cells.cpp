#include "lib/tool/foot_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gouge {
namespace {

constexpr double kMargin_rad = 1e-6;  // extension of a vertex cell, because the normals of its neighbours are rounded
constexpr double kLargestTurn_rad = 0.5 * std::numbers::pi;

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// Returns the outward normal of an element at one of its ends; for a vertex its mean normal.
Vec2 normal_at(const BoundaryElement& e, const Vec2& end) {
  if (e.kind != ElementKind::arc) return e.normal;
  const Vec2 out = (end - e.center).normalized();
  return e.is_reflex ? Vec2(-out) : out;
}

FootCell straight(const BoundaryElement& e) {
  FootCell cell;
  cell.origin = e.a;
  cell.along = (e.b - e.a).normalized();
  cell.inward = -e.normal;
  cell.to = (e.b - e.a).norm();
  return cell;
}

FootCell round(const Vec2& origin, const Vec2& middle, double half_rad, double radius_mm, double side) {
  FootCell cell;
  cell.origin = origin;
  cell.radius_mm = radius_mm;
  cell.side = side;
  cell.from = angle_of(middle) - half_rad;
  cell.to = angle_of(middle) + half_rad;
  return cell;
}

FootCell of_arc(const BoundaryElement& e) {
  const double half = angle_between(e.normal, e.a - e.center);
  return round(e.center, e.normal, half, e.radius_mm, e.is_reflex ? 1.0 : -1.0);
}

/// Returns the cell of a reflex corner. Its rays lie between the normals of its neighbours; on the axis the mirrored
/// contour is a neighbour.
FootCell of_corner(const CompiledTool& tool, std::size_t i) {
  const BoundaryElement& e = tool.elements[i];
  const auto mirrored = [](const Vec2& n) { return Vec2(-n.x(), n.y()); };
  const std::size_t last = tool.elements.size() - 1;
  const Vec2 after = i < last ? normal_at(tool.elements[i + 1], e.a) : mirrored(normal_at(tool.elements[i - 1], e.a));
  const Vec2 before = i > 0 ? normal_at(tool.elements[i - 1], e.a) : mirrored(after);
  const double half = std::max(angle_between(e.normal, before), angle_between(e.normal, after)) + kMargin_rad;
  return round(e.a, -e.normal, half, 0, 1);
}

void add_in_parts(const FootCell& whole, std::vector<FootCell>& cells) {
  const double turn = whole.is_straight() ? 0 : whole.to - whole.from;
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / kLargestTurn_rad)));
  for (int k = 0; k < parts; ++k) {
    FootCell cell = whole;
    cell.from = whole.from + (whole.to - whole.from) * k / parts;
    cell.to = k + 1 == parts ? whole.to : whole.from + (whole.to - whole.from) * (k + 1) / parts;
    cells.push_back(cell);
  }
}

}  // namespace

Vec2 FootCell::inward_at(double s) const { return is_straight() ? inward : Vec2(side * direction(s)); }

Vec2 FootCell::at(double s, double t) const {
  if (is_straight()) return origin + s * along + t * inward;
  return origin + (radius_mm + side * t) * direction(s);
}

double FootCell::longest_ray_mm() const {
  return !is_straight() && side < 0 ? radius_mm : std::numeric_limits<double>::infinity();
}

double FootCell::width_mm(double t) const {
  return (to - from) * (is_straight() ? 1.0 : std::abs(radius_mm + side * t));
}

double FootCell::farthest_mm(const Vec2& place, double t) const {
  // Along a ray the distance is convex. About the centre it increases with the angle from the point.
  double farthest = 0;
  const double length = std::min(t, longest_ray_mm());
  for (const double s : {from, to}) {
    for (const double height : {0.0, length}) farthest = std::max(farthest, (at(s, height) - place).norm());
  }
  if (is_straight()) return farthest;
  const double opposite = angle_of(origin - place);
  const double turn = std::remainder(opposite - middle(), 2 * std::numbers::pi);
  if (std::abs(turn) >= 0.5 * (to - from)) return farthest;
  return (place - origin).norm() + std::max(radius_mm, std::abs(radius_mm + side * length));
}

bool FootCell::rays_meet(const Vec2& place, double within_mm) const {
  const double half = 0.5 * (to - from);
  if (is_straight()) return half < within_mm;
  const double distance = (place - origin).norm();
  // If the rays lead away from the centre, a ray at too wide an angle only moves away from the point.
  if (half >= kLargestTurn_rad || (side > 0 && distance * std::cos(half) < radius_mm)) return false;
  return distance * std::sin(half) < within_mm;
}

std::vector<FootCell> foot_cells(const CompiledTool& tool) {
  std::vector<FootCell> cells;
  if (tool.elements.size() < 2) return cells;
  for (std::size_t i = 0; i < tool.elements.size(); ++i) {
    const BoundaryElement& e = tool.elements[i];
    if (e.kind == ElementKind::segment) add_in_parts(straight(e), cells);
    if (e.kind == ElementKind::arc) add_in_parts(of_arc(e), cells);
    if (e.kind == ElementKind::vertex && e.is_reflex) add_in_parts(of_corner(tool, i), cells);
  }
  return cells;
}

}  // namespace gouge
