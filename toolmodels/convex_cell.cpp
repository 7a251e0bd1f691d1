#include "toolmodels/convex_cell.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge::detail {
namespace {

constexpr double kMinNorm = 1e-300;
constexpr double kCellSlack = 1e-13;  // relative to the size; two of these slacks keep results within 1e-12

double value(const DirectedLine& line, const Vec3& c) {
  return c.z() > 0 ? line.at(c.head<2>()) : line.direction.dot(c.head<2>());
}

Vec3 between(const Vec3& p, double vp, const Vec3& q, double vq) {
  // The combination of both homogeneous corners, with positive weights, at which the line's value is zero.
  const Vec3 mix = std::abs(vq) * p + std::abs(vp) * q;
  if (mix.z() > 0) return mix / mix.z();
  return Vec3(mix.x(), mix.y(), 0) / std::max(mix.head<2>().norm(), kMinNorm);
}

}  // namespace

ConvexCell::ConvexCell(double size_mm)
    : corners_{Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, size_mm_(size_mm) {}

double ConvexCell::slack_at(const Vec3& c) const {
  if (!(c.z() > 0)) return Tolerance::kSingular;
  return kCellSlack * (size_mm_ + std::abs(c.x()) + std::abs(c.y()));
}

CellSides ConvexCell::sides(const DirectedLine& line) const {
  CellSides sides;
  for (const Vec3& c : corners_) {
    const double v = value(line, c);
    if (v > slack_at(c)) sides.has_positive = true;
    if (v < -slack_at(c)) sides.has_negative = true;
  }
  return sides;
}

ConvexCell ConvexCell::clipped(const DirectedLine& line, int sign) const {
  ConvexCell part(*this);
  part.corners_.clear();
  const auto side_value = [&](const Vec3& c) {
    const double v = sign * value(line, c);
    return std::abs(v) <= slack_at(c) ? 0.0 : v;
  };
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec3& p = corners_[i];
    const Vec3& q = corners_[(i + 1) % corners_.size()];
    const double vp = side_value(p);
    const double vq = side_value(q);
    if (vp >= 0) part.corners_.push_back(p);
    if ((vp > 0 && vq < 0) || (vp < 0 && vq > 0)) part.corners_.push_back(between(p, vp, q, vq));
  }
  part.add_corner_amid(line);
  return part;
}

// Adds the point `line.through` of a cut as a corner if it lies inside the new edge. Nearly parallel lines meet far
// away, where the slack makes values useless for points near the tool. An edge between two opposite directions has no
// other finite point.
void ConvexCell::add_corner_amid(const DirectedLine& line) {
  const Vec2 along(-line.direction.y(), line.direction.x());
  const auto is_on_line = [&](const Vec3& c) { return std::abs(value(line, c)) <= slack_at(c); };
  const auto place = [&](const Vec3& c) {
    const double at = along.dot(c.z() > 0 ? Vec2(c.head<2>() - line.through) : Vec2(c.head<2>()));
    return std::abs(at) <= slack_at(c) ? 0.0 : at;
  };
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec3& p = corners_[i];
    const Vec3& q = corners_[(i + 1) % corners_.size()];
    if (!is_on_line(p) || !is_on_line(q)) continue;
    const double at_p = place(p);
    const double at_q = place(q);
    if (!((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0))) continue;
    corners_.insert(corners_.begin() + static_cast<std::ptrdiff_t>(i) + 1, Vec3(line.through.x(), line.through.y(), 1));
    return;
  }
}

std::vector<Vec2> ConvexCell::samples() const {
  std::vector<Vec2> points;
  Vec2 mean = Vec2::Zero();
  Vec2 outward = Vec2::Zero();
  for (const Vec3& c : corners_) {
    if (c.z() > 0) {
      points.emplace_back(c.head<2>());
      mean += c.head<2>();
    } else {
      outward += c.head<2>();
    }
  }
  if (!points.empty()) mean /= static_cast<double>(points.size());
  points.insert(points.begin(), mean + size_mm_ * outward);
  return points;
}

double ConvexCell::area_within(const Vec2& low, const Vec2& high) const {
  const ConvexCell box = clipped({low, Vec2::UnitX()}, 1)
                             .clipped({low, Vec2::UnitY()}, 1)
                             .clipped({high, Vec2::UnitX()}, -1)
                             .clipped({high, Vec2::UnitY()}, -1);
  double doubled = 0;
  for (std::size_t i = 0; i < box.corners_.size(); ++i) {
    const Vec3& p = box.corners_[i];
    const Vec3& q = box.corners_[(i + 1) % box.corners_.size()];
    doubled += p.x() * q.y() - p.y() * q.x();
  }
  return std::abs(doubled) / 2;
}

}  // namespace gouge::detail
