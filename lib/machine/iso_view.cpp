#include "lib/machine/iso_view.h"

#include <cmath>
#include <numbers>

#include "lib/base/units.h"

namespace gouge {
namespace {

constexpr double kHead = 12;  // length of the head of an arrow
// The direction to the viewer. No circle about an axis at 45 degrees to X, Y or Z appears as a line.
constexpr double kAround = -40 * kDegree_rad, kAbove = 22 * kDegree_rad;
constexpr int kRound = 72;  // corners of a circle

Colour shaded(const Colour& colour, double share) {
  const auto part = [&](unsigned char value) { return static_cast<unsigned char>(value * share); };
  return {part(colour.r), part(colour.g), part(colour.b), colour.opacity};
}

double angle_of(int step, int steps, double whole = 2 * std::numbers::pi) { return whole * step / steps; }

/// Returns a unit vector across `axis`.
Vec3 across(const Vec3& axis) {
  const Vec3 other = std::abs(axis.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  return axis.cross(other).normalized();
}

}  // namespace

Vec2 IsoView::at(const Vec3& point) const {
  static const double sa = std::sin(kAround), ca = std::cos(kAround), se = std::sin(kAbove), ce = std::cos(kAbove);
  static const Vec3 right(-sa, ca, 0), up(-se * ca, -se * sa, ce);
  return origin_ + Vec2(right.dot(point), -up.dot(point));
}

void IsoView::shape(std::vector<Vec2> points, const Colour& fill, const Colour* outline) {
  drawing_.items.emplace_back(DrawnShape{points, fill});
  if (outline != nullptr) drawing_.items.emplace_back(DrawnLine{std::move(points), *outline, 1.2, true, {}});
}

void IsoView::head(const Vec2& tip, const Vec2& along, const Colour& colour, double size) {
  const Vec2 back = tip - size * along, side = 0.36 * size * Vec2(-along.y(), along.x());
  shape({tip, back + side, back - side}, colour, nullptr);
}

void IsoView::line(const Vec3& from, const Vec3& to, const Colour& colour, double width,
                   const std::vector<double>& dashes) {
  drawing_.items.emplace_back(DrawnLine{{at(from), at(to)}, colour, width, false, dashes});
}

void IsoView::arrow(const Vec3& from, const Vec3& to, const Colour& colour, double width) {
  const Vec2 tip = at(to), way = tip - at(from);
  const double length = way.norm();
  const double size = kHead + width;
  if (length > size) {
    const Vec2 along = way / length;
    drawing_.items.emplace_back(DrawnLine{{at(from), tip - 0.8 * size * along}, colour, width, false, {}});
    return head(tip, along, colour, size);
  }
  dot(to, 4, colour, true);  // it points at the viewer
}

void IsoView::turn_arrow(const Vec3& middle, const Vec3& axis, double radius, const Colour& colour, double width) {
  constexpr double kArc = 1.5 * std::numbers::pi;
  const Vec3 e = across(axis), f = axis.cross(e);
  DrawnLine arc{{}, colour, width, false, {}};
  const int steps = kRound;
  for (int k = 0; k <= steps; ++k) {
    const double t = angle_of(k, steps, kArc);
    arc.points.push_back(at(middle + radius * (std::cos(t) * e + std::sin(t) * f)));
  }
  const Vec2 tip = arc.points.back(), along = (tip - arc.points[arc.points.size() - 4]).normalized();
  for (int k = 0; k < 3; ++k) arc.points.pop_back();
  drawing_.items.emplace_back(std::move(arc));
  head(tip + 3 * along, along, colour, kHead + width);
}

void IsoView::cylinder(const Vec3& low, double height, double radius, const Colour& fill, const Colour& outline) {
  const auto rim = [&](double z, double from, double whole) {
    std::vector<Vec2> points;
    for (int k = 0; k <= kRound; ++k) {
      const double t = from + angle_of(k, kRound, whole);
      points.push_back(at(low + Vec3(radius * std::cos(t), radius * std::sin(t), z)));
    }
    return points;
  };
  constexpr double kLeft = kAround - 0.5 * std::numbers::pi;  // the near half of the rim begins on the left
  std::vector<Vec2> side = rim(0, kLeft, std::numbers::pi);
  const std::vector<Vec2> top = rim(height, kLeft, std::numbers::pi);
  side.insert(side.end(), top.rbegin(), top.rend());
  shape(std::move(side), shaded(fill, 0.88), &outline);
  shape(rim(height, 0, 2 * std::numbers::pi), fill, &outline);
}

void IsoView::box(const Vec3& low, const Vec3& high, const Colour& fill, const Colour& outline) {
  const auto corner = [&](bool x, bool y, bool z) {
    return at(Vec3(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z()));
  };
  shape(
      {corner(false, false, false), corner(true, false, false), corner(true, false, true), corner(false, false, true)},
      shaded(fill, 0.92), &outline);
  shape({corner(true, false, false), corner(true, true, false), corner(true, true, true), corner(true, false, true)},
        shaded(fill, 0.82), &outline);
  shape({corner(false, false, true), corner(true, false, true), corner(true, true, true), corner(false, true, true)},
        fill, &outline);
}

void IsoView::dot(const Vec3& place, double radius, const Colour& colour, bool is_filled) {
  std::vector<Vec2> points;
  for (int k = 0; k < kRound; ++k) {
    const double t = angle_of(k, kRound);
    points.push_back(at(place) + radius * Vec2(std::cos(t), std::sin(t)));
  }
  if (is_filled) return shape(std::move(points), colour, nullptr);
  drawing_.items.emplace_back(DrawnShape{points, {255, 255, 255, 1}});
  drawing_.items.emplace_back(DrawnLine{std::move(points), colour, 2, true, {}});
}

void IsoView::zero_mark(const Vec3& place, double radius, const Colour& colour) {
  dot(place, radius, colour, false);
  for (const double from : {0.0, std::numbers::pi}) {
    std::vector<Vec2> quarter = {at(place)};
    for (int k = 0; k <= kRound / 4; ++k) {
      const double t = from + angle_of(k, kRound);
      quarter.push_back(at(place) + radius * Vec2(std::cos(t), std::sin(t)));
    }
    shape(std::move(quarter), colour, nullptr);
  }
}

void IsoView::end_label(const Vec3& from, const Vec3& to, const std::vector<std::string>& lines, const Colour& colour) {
  constexpr double kName = 19, kLine = 14, kStep = 17, kGap = 12, kFlat = 0.35;
  const Vec2 way = at(to) - at(from);
  const Vec2 along = way.norm() > 0 ? Vec2(way / way.norm()) : Vec2(0, -1);
  const TextAnchor anchor = std::abs(along.x()) < kFlat ? TextAnchor::middle
                            : along.x() > 0             ? TextAnchor::left
                                                        : TextAnchor::right;
  const double height = kStep * static_cast<double>(lines.size() - 1);
  Vec2 place = at(to) + kGap * along + Vec2(0, 6);
  if (along.y() < -kFlat) place.y() -= height;
  if (along.y() > kFlat) place.y() += 8;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double size = i == 0 ? kName : kLine;
    clear(place + Vec2(0, kStep * static_cast<double>(i)), lines[i].size(), size, anchor);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    text(place + Vec2(0, kStep * static_cast<double>(i)), lines[i], i == 0 ? kName : kLine, colour, anchor, i == 0);
}

void IsoView::clear(const Vec2& place, std::size_t letters, double size, TextAnchor anchor) {
  constexpr double kLetter = 0.62;  // mean width of a letter, in sizes
  const double width = kLetter * size * static_cast<double>(letters);
  const double left = anchor == TextAnchor::left ? 0 : anchor == TextAnchor::right ? width : 0.5 * width;
  const Vec2 low = place + Vec2(-left - 2, 0.25 * size), high = low + Vec2(width + 4, -1.15 * size);
  shape({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {255, 255, 255, 0.85}, nullptr);
}

void IsoView::text(const Vec2& place, const std::string& text, double size, const Colour& colour, TextAnchor anchor,
                   bool is_bold) {
  drawing_.items.emplace_back(DrawnText{place, text, size, colour, anchor, is_bold});
}

}  // namespace gouge
