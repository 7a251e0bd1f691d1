#include "toolmodels/voronoi.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge::detail {
namespace {

using Kind = Comparison::Kind;

// ---- domains

Vec2 travel(const BoundaryElement& e, const Vec2& at) {
  if (e.kind == ElementKind::segment) return {-e.normal.y(), e.normal.x()};
  const Vec2 out = (at - e.center).normalized();
  return e.is_reflex ? Vec2(out.y(), -out.x()) : Vec2(-out.y(), out.x());
}

// ---- bounds of one form at a homogeneous corner

double at_corner(const DistanceForm& f, const Vec3& c) {
  const bool is_point = c.z() > 0;
  if (f.is_linear) return f.direction.dot(is_point ? Vec2(c.head<2>() - f.through) : Vec2(c.head<2>()));
  return is_point ? f.sign * (c.head<2>() - f.center).norm() + f.shift : f.sign;
}

// Returns the tangent plane of a circular form at `touch`. It lies above a concave form and below a convex one.
std::optional<DistanceForm> tangent_form(const DistanceForm& f, const Vec2& touch) {
  const Vec2 away = touch - f.center;
  const double length = away.norm();
  if (!(length > 0)) return std::nullopt;
  DistanceForm plane;
  plane.direction = f.sign * away / length;
  plane.through = f.center - f.shift * plane.direction;
  return plane;
}

bool is_below_at_corners(const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell) {
  return std::all_of(cell.corners().begin(), cell.corners().end(),
                     [&](const Vec3& c) { return at_corner(f, c) - at_corner(g, c) <= cell.slack_at(c); });
}

bool is_convex(const DistanceForm& f) { return f.is_linear || f.sign > 0; }
bool is_concave(const DistanceForm& f) { return f.is_linear || f.sign < 0; }

// ---- comparisons

Comparison decided(bool is_first_nearer) {
  Comparison c;
  c.kind = is_first_nearer ? Kind::first_nearer : Kind::second_nearer;
  return c;
}

Comparison split(const DirectedLine& line) {
  Comparison c;
  c.kind = Kind::split_first;
  c.line = line;
  return c;
}

Comparison straight(const DirectedLine& line) {
  Comparison c;
  c.line = line;
  c.is_straight = true;
  c.curve = straight_node(line);
  return c;
}

// Returns the curve square (v0 + gradient . x)^2 + round |x|^2 = 0 with x = q - origin.
Comparison curved(const Vec2& origin, double v0, const Vec2& gradient, double square, double round) {
  Comparison c;
  c.curve.origin = origin;
  c.curve.v0 = v0;
  c.curve.vx = gradient.x();
  c.curve.vy = gradient.y();
  c.curve.square = square;
  c.curve.round = round;
  return c;
}

// Returns the line gradient . (q - origin) + offset = 0 with a unit direction; `through` is the foot of the origin.
DirectedLine line_of(const Vec2& origin, const Vec2& gradient, double offset) {
  const double length = gradient.norm();
  return {origin - offset / (length * length) * gradient, gradient / length};
}

Comparison compare_linear(const DistanceForm& f, const DistanceForm& g) {
  const Vec2 gradient = f.direction - g.direction;
  const double offset = g.direction.dot(g.through - f.through);  // value at f.through
  if (gradient.norm() <= Tolerance::kSingular) return decided(offset <= 0);
  return straight(line_of(f.through, gradient, offset));
}

// Compares sign A + shift with a line, where A is the distance from a centre. The curve is A = m with m linear: a
// parabola with its focus at the centre.
Comparison compare_circle_line(const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell) {
  const Vec2 slope = f.sign * g.direction;
  const double offset = f.sign * (g.direction.dot(f.center - g.through) - f.shift);
  const DirectedLine m{f.center - offset * slope, slope};
  const CellSides sides = cell.sides(m);
  if (!sides.has_positive) return decided(f.sign < 0);
  if (sides.has_negative) return split(m);
  return curved(f.center, offset, slope, -f.sign, f.sign);
}

// Compares A with B + k for k >= 0, where A = |x - w|, B = |x| and x = q - origin. The curve is one branch of a
// hyperbola. `factor` is 1 if the first distance is A.
Comparison compare_difference(const Vec2& origin, const Vec2& w, double k, double factor, const ConvexCell& cell) {
  const double distance = w.norm();
  if (k >= distance) return decided(factor > 0);
  const double constant = (distance - k) * (distance + k);
  const DirectedLine limit = line_of(origin, -2 * w, constant);
  if (k <= Tolerance::kSingular * distance) return straight({limit.through, factor * limit.direction});
  const CellSides sides = cell.sides(limit);
  if (!sides.has_positive) return decided(factor > 0);
  if (sides.has_negative) return split(limit);
  const double share = 2 * k / distance;
  return curved(origin, constant / distance, -2 / distance * w, factor, -factor * share * share);
}

// Compares A + B with k. The curve is an ellipse. `factor` is 1 if the first distance is smaller inside it.
Comparison compare_sum(const Vec2& origin, const Vec2& w, double k, double factor) {
  const double distance = w.norm();
  if (k <= distance) return decided(factor < 0);
  const double constant = (distance - k) * (distance + k);
  return curved(origin, constant / k, -2 / k * w, -factor, 4 * factor);
}

Comparison compare_circles(const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell) {
  const double k = f.sign * (g.shift - f.shift);
  if (f.sign * g.sign < 0) {
    // The origin is the centre that is nearer to its own boundary, because the other may be hundreds of sizes away.
    return std::abs(g.shift) <= std::abs(f.shift) ? compare_sum(g.center, f.center - g.center, k, f.sign)
                                                  : compare_sum(f.center, g.center - f.center, k, f.sign);
  }
  if (k >= 0) return compare_difference(g.center, f.center - g.center, k, f.sign, cell);
  return compare_difference(f.center, g.center - f.center, -k, -f.sign, cell);
}

}  // namespace

DistanceForm DistanceForm::negated() const {
  DistanceForm form = *this;
  form.direction = -direction;
  form.sign = -sign;
  form.shift = -shift;
  return form;
}

DistanceForm signed_form(const BoundaryElement& e) {
  DistanceForm form;
  if (e.kind == ElementKind::segment) {
    form.through = e.a;
    form.direction = e.normal;
    return form;
  }
  form.is_linear = false;
  form.center = e.kind == ElementKind::vertex ? e.a : e.center;
  form.sign = e.is_reflex ? -1 : 1;
  form.shift = -form.sign * (e.kind == ElementKind::vertex ? 0.0 : e.radius_mm);
  return form;
}

Domains make_domains(const std::vector<BoundaryElement>& elements) {
  Domains domains;
  domains.bounds.resize(elements.size());
  const auto bound = [&](const Vec2& through, const Vec2& direction, std::size_t before, std::size_t after) {
    domains.lines.push_back({through, direction});
    domains.bounds[before].push_back({domains.lines.size() - 1, -1});
    domains.bounds[after].push_back({domains.lines.size() - 1, 1});
  };
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    const BoundaryElement& e = elements[i];
    const BoundaryElement& next = elements[i + 1];
    if (next.kind == ElementKind::vertex)
      bound(e.b, travel(e, e.b), i, i + 1);
    else if (e.kind == ElementKind::vertex)
      bound(next.a, travel(next, next.a), i, i + 1);
    else
      bound(e.b, (travel(e, e.b) + travel(next, next.a)).normalized(), i, i + 1);
  }
  return domains;
}

bool is_everywhere_below(const DistanceForm& f, const DistanceForm& g, const ConvexCell& cell) {
  if (is_convex(f) && is_concave(g)) return is_below_at_corners(f, g, cell);
  for (const Vec2& touch : cell.samples()) {
    const std::optional<DistanceForm> above = is_convex(f) ? std::optional(f) : tangent_form(f, touch);
    const std::optional<DistanceForm> below = is_concave(g) ? std::optional(g) : tangent_form(g, touch);
    if (above && below && is_below_at_corners(*above, *below, cell)) return true;
  }
  return false;
}

Comparison compare(const DistanceForm& first, const DistanceForm& second, const ConvexCell& cell) {
  if (first.is_linear && second.is_linear) return compare_linear(first, second);
  if (!first.is_linear && !second.is_linear) return compare_circles(first, second, cell);
  if (!first.is_linear) return compare_circle_line(first, second, cell);
  Comparison swapped = compare_circle_line(second, first, cell);
  if (swapped.kind == Kind::first_nearer) return decided(false);
  if (swapped.kind == Kind::second_nearer) return decided(true);
  swapped.curve.square = -swapped.curve.square;
  swapped.curve.round = -swapped.curve.round;
  return swapped;
}

BspNode straight_node(const DirectedLine& line) {
  BspNode node;
  node.origin = line.through;
  node.vx = line.direction.x();
  node.vy = line.direction.y();
  node.linear = 1;
  return node;
}

}  // namespace gouge::detail
