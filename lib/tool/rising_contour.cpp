#include "lib/tool/rising_contour.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"

namespace gouge {
namespace {

/// Returns the part of an element between two of its points, in its direction.
BoundaryElement part_of(const BoundaryElement& whole, const Vec2& a, const Vec2& b) {
  BoundaryElement part = whole;
  part.a = a;
  part.b = b;
  if (whole.kind == ElementKind::arc) {
    const Vec2 middle = 0.5 * (a + b) - whole.center;
    if (middle.norm() > 0) part.normal = (whole.normal.dot(middle) < 0 ? -1 : 1) * middle.normalized();
  }
  return part;
}

/// Returns the lowest and the highest point of an arc's circle that the arc passes, in its direction. Ends do not count.
std::vector<Vec2> poles_of(const BoundaryElement& e) {
  std::vector<Vec2> poles;
  if (e.kind != ElementKind::arc) return poles;
  const double turn = e.is_reflex ? -1 : 1;
  for (const double side : {-1.0, 1.0}) {
    const Vec2 out(0, side), pole = e.center + e.radius_mm * out;
    const double slack = Tolerance::kSameDirection * e.radius_mm;
    if (turn * cross(e.a - e.center, out) > slack && turn * cross(out, e.b - e.center) > slack) poles.push_back(pole);
  }
  return poles;
}

/// Returns the point of a rising element at a height between its ends.
Vec2 point_at_height(const BoundaryElement& e, double height) {
  if (e.kind != ElementKind::arc)
    return {e.a.x() + (height - e.a.y()) / (e.b.y() - e.a.y()) * (e.b.x() - e.a.x()), height};
  const double rise = height - e.center.y();
  const double half = std::sqrt(std::max(0.0, (e.radius_mm - rise) * (e.radius_mm + rise)));
  const double middle = 0.5 * (e.a.x() + e.b.x());
  return {middle < e.center.x() ? e.center.x() - half : e.center.x() + half, height};
}

double widest(const BoundaryElement& e) {
  const double ends = std::max(e.a.x(), e.b.x());
  return e.kind == ElementKind::arc && !e.is_reflex ? std::max(ends, e.center.x() + e.radius_mm) : ends;
}

/// Returns a bound of the radius of a rising element above a height.
double widest_above(const BoundaryElement& e, double height) {
  const Vec2 from = point_at_height(e, height);
  const bool may_bulge = e.kind == ElementKind::arc && !e.is_reflex && from.y() < e.center.y();
  return may_bulge ? widest(e) : std::max(from.x(), e.b.x());
}

class OverhangFiller {
 public:
  explicit OverhangFiller(double max_fill_mm) : max_fill_mm_(max_fill_mm) {}

  /// Takes the next element, which rises or falls throughout. Returns whether the fill is possible so far.
  bool take(const BoundaryElement& e) {
    if (is_in_pit_) return e.b.y() <= rising_.back().b.y();
    if (e.b.y() >= e.a.y()) {
      rising_.push_back(e);
      return true;
    }
    if (e.b.x() >= e.a.x()) return fill_below(e);
    is_in_pit_ = true;
    rim_fill_mm_ = std::max(rim_fill_mm_, e.a.y() - e.b.y());
    return !rising_.empty() && rim_fill_mm_ <= max_fill_mm_;
  }

  std::vector<BoundaryElement> finish() {
    if (is_in_pit_) add_level(rising_.back(), rising_.back().b, {0, rising_.back().b.y()});
    return std::move(rising_);
  }

 private:
  /// Cuts the contour so far at the lowest point of a falling element, and goes on level from there.
  bool fill_below(const BoundaryElement& e) {
    const double low = e.b.y();
    if (e.a.y() - low > max_fill_mm_) return false;
    // No part that is cut off may be wider than the level line.
    while (!rising_.empty() && rising_.back().a.y() >= low) {
      if (widest(rising_.back()) > e.b.x()) return false;
      rising_.pop_back();
    }
    if (!rising_.empty() && rising_.back().b.y() > low && widest_above(rising_.back(), low) > e.b.x()) return false;
    Vec2 from(0, low);
    if (!rising_.empty()) {
      BoundaryElement& last = rising_.back();
      from = last.b;
      if (last.b.y() > low) {
        from = point_at_height(last, low);
        last = part_of(last, last.a, from);
      }
    }
    add_level(e, from, e.b);
    return true;
  }

  void add_level(const BoundaryElement& like, const Vec2& from, const Vec2& to) {
    BoundaryElement level;
    level.kind = ElementKind::segment;
    level.body = like.body;
    level.a = from;
    level.b = {to.x(), from.y()};
    level.normal = Vec2(0, to.x() >= from.x() ? -1 : 1);
    rising_.push_back(level);
  }

  double max_fill_mm_;
  std::vector<BoundaryElement> rising_;
  bool is_in_pit_ = false;
  double rim_fill_mm_ = 0;
};

}  // namespace

std::optional<std::vector<BoundaryElement>> fill_overhangs(const std::vector<BoundaryElement>& elements,
                                                           double max_fill_mm) {
  OverhangFiller filler(max_fill_mm);
  for (const BoundaryElement& e : elements) {
    if (e.kind == ElementKind::vertex) continue;
    Vec2 from = e.a;
    std::vector<Vec2> ends = poles_of(e);
    ends.push_back(e.b);
    for (const Vec2& end : ends) {
      if (!filler.take(part_of(e, from, end))) return std::nullopt;
      from = end;
    }
  }
  return filler.finish();
}

}  // namespace gouge
