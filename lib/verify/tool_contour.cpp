#include "lib/verify/tool_contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/geom/vec.h"

namespace gouge {
namespace {

// Returns whether a monotone piece contains the height. It includes its lower end but not its upper end, so that a
// joint counts once.
bool holds_height(const ToolContour::Piece& p, double z) { return (p.a.y() <= z) != (p.b.y() <= z); }

// Returns the radius at which a monotone piece passes a height that it contains.
double radius_at(const ToolContour::Piece& p, double z) {
  if (!p.is_arc) return p.a.x() + (z - p.a.y()) / (p.b.y() - p.a.y()) * (p.b.x() - p.a.x());
  const double up = z - p.center.y();
  const double out = std::sqrt(std::max(0.0, p.radius_mm * p.radius_mm - up * up));
  return p.a.x() + p.b.x() >= 2 * p.center.x() ? p.center.x() + out : p.center.x() - out;
}

Vec2 outward(const ToolContour::Piece& p, const Vec2& foot) {
  if (p.is_arc) return (p.is_hollow ? -1.0 : 1.0) * (foot - p.center) / p.radius_mm;
  const Vec2 along = p.b - p.a;
  return Vec2(along.y(), -along.x()).normalized();  // the contour runs from the tip up, with the tool on its left
}

}  // namespace

Vec2 ToolContour::Piece::foot(const Vec2& q) const {
  if (is_arc) {
    const Vec2 away = q - center;
    const double distance = away.norm(), side = cross(a - center, b - center) > 0 ? 1 : -1;
    if (distance > 0 && side * cross(a - center, away) >= 0 && side * cross(away, b - center) >= 0)
      return center + radius_mm / distance * away;
    return (q - a).squaredNorm() <= (q - b).squaredNorm() ? a : b;
  }
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0 ? std::clamp((q - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return a + s * along;
}

ToolContour::ToolContour(const CompiledTool& tool) {
  for (const BoundaryElement& e : tool.elements) {
    if (e.kind == ElementKind::arc) add_arc(e);
    if (e.kind == ElementKind::segment) pieces_.push_back({e.body, false, false, e.a, e.b, Vec2::Zero(), 0});
  }
  for (const BoundaryElement& e : tool.elements) is_stepped_ = is_stepped_ || e.is_reflex;
  if (!pieces_.empty()) low_mm_ = high_mm_ = pieces_.front().a.y();
  for (const Piece& p : pieces_) {
    low_mm_ = std::min(low_mm_, p.z_lo());
    high_mm_ = std::max(high_mm_, p.z_hi());
    size_mm_ = std::max({size_mm_, p.a.norm(), p.b.norm()});
    largest_radius_mm_ = std::max(largest_radius_mm_, p.r_hi());
  }
}

void ToolContour::add_arc(const BoundaryElement& arc) {
  const double turn = arc.is_reflex ? -1 : 1;
  const Vec2 from = arc.a - arc.center, to = arc.b - arc.center;
  std::vector<Vec2> cuts;
  for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    if (turn * cross(from, d) > 0 && turn * cross(d, to) > 0) cuts.push_back(d);
  std::sort(cuts.begin(), cuts.end(), [&](const Vec2& x, const Vec2& y) { return from.dot(x) > from.dot(y); });
  Vec2 start = arc.a;
  for (const Vec2& d : cuts) {
    const Vec2 end = arc.center + arc.radius_mm * d;
    pieces_.push_back({arc.body, true, arc.is_reflex, start, end, arc.center, arc.radius_mm});
    start = end;
  }
  pieces_.push_back({arc.body, true, arc.is_reflex, start, arc.b, arc.center, arc.radius_mm});
}

double ToolContour::largest_gap_mm() const {
  if (pieces_.empty()) return 0;
  double gap = std::max(pieces_.front().a.x(), pieces_.back().b.x());
  for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) gap = std::max(gap, (pieces_[i].b - pieces_[i + 1].a).norm());
  for (const Piece& p : pieces_) {
    if (!p.is_arc) continue;
    for (const Vec2& end : {p.a, p.b}) gap = std::max(gap, std::abs((end - p.center).norm() - p.radius_mm));
  }
  return gap;
}

bool ToolContour::has(const Vec2& q) const {
  bool is_inside = false;
  for (const Piece& p : pieces_)
    if (holds_height(p, q.y()) && radius_at(p, q.y()) > q.x()) is_inside = !is_inside;
  return is_inside;
}

ToolContour::Nearest ToolContour::nearest(const Vec2& q) const {
  Nearest best;
  double least2 = std::numeric_limits<double>::infinity();
  const Piece* at = nullptr;
  for (const Piece& p : pieces_) {
    const Vec2 foot = p.foot(q);
    const double distance2 = (q - foot).squaredNorm();
    if (!(distance2 < least2)) continue;
    least2 = distance2;
    best.foot = foot;
    at = &p;
  }
  if (at == nullptr) return best;
  const double distance = std::sqrt(least2), sign = has(q) ? -1 : 1;
  best.signed_distance_mm = sign * distance;
  best.body = at->body;
  best.normal = distance > 1e-9 ? Vec2(sign / distance * (q - best.foot)) : outward(*at, best.foot);
  return best;
}

double ToolContour::distance_to(Body body, const Vec2& q) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& p : pieces_)
    if (p.body == body) least = std::min(least, (q - p.foot(q)).norm());
  return least;
}

}  // namespace gouge
