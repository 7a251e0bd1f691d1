#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/geom/vec.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr std::size_t kDeepest = 64;  // depth of a tree over 2^32 elements, halved at every level

double signed_distance(const BoundaryElement& e, const Vec2& q) {
  if (e.kind == ElementKind::segment) return e.normal.dot(q - e.a);
  const double sign = e.is_reflex ? -1.0 : 1.0;
  if (e.kind == ElementKind::vertex) return sign * std::sqrt((q - e.a).squaredNorm());
  return sign * (std::sqrt((q - e.center).squaredNorm()) - e.radius_mm);
}

double side_of(const DomainBorder& border, const Vec2& q) {
  return border.offset + border.direction.dot(q - border.through);
}

double squared_distance(const ContourStretch& stretch, const Vec2& q) {
  const Vec2 away = q - stretch.origin;
  const double u = stretch.along.dot(away), v = cross(stretch.along, away);
  const double du = std::max({stretch.low.x() - u, 0.0, u - stretch.high.x()});
  const double dv = std::max({stretch.low.y() - v, 0.0, v - stretch.high.y()});
  return du * du + dv * dv;
}

class NearestElementSearch {
 public:
  NearestElementSearch(const CompiledTool& tool, const Vec2& q) : tool_(tool), q_(q) {}

  std::uint32_t run() {
    push(0, squared_distance(tool_.stretches.front(), q_));
    while (open_count_ > 0) {
      const Open next = open_[--open_count_];
      if (next.squared_distance > nearest_ * nearest_) continue;
      const ContourStretch& stretch = tool_.stretches[next.stretch];
      if (stretch.second == 0)
        look_at(stretch);
      else
        open_halves(next.stretch + 1, stretch.second);
    }
    return element_;
  }

 private:
  struct Open {
    std::uint32_t stretch;
    double squared_distance;
  };

  void push(std::uint32_t stretch, double squared) { open_[open_count_++] = {stretch, squared}; }

  // Pushes both halves so that the nearer one is examined first.
  void open_halves(std::uint32_t one, std::uint32_t other) {
    const double d = squared_distance(tool_.stretches[one], q_);
    const double e = squared_distance(tool_.stretches[other], q_);
    if (d < e) {
      push(other, e);
      push(one, d);
    } else {
      push(one, d);
      push(other, e);
    }
  }

  // Walks along the contour and remembers the value at the last border. Every point is in the domain of at least one
  // element.
  void look_at(const ContourStretch& stretch) {
    double behind = stretch.first > 0 ? side_of(tool_.borders[stretch.first - 1], q_) : 0;
    for (std::uint32_t k = stretch.first; k < stretch.last; ++k) {
      const double ahead = k < tool_.borders.size() ? side_of(tool_.borders[k], q_) : -1;
      const bool is_in_domain = behind >= 0 && ahead < 0;
      behind = ahead;
      if (!is_in_domain) continue;
      const double distance = std::abs(signed_distance(tool_.elements[k], q_));
      if (distance >= nearest_) continue;
      nearest_ = distance;
      element_ = k;
    }
  }

  const CompiledTool& tool_;
  Vec2 q_;
  std::array<Open, kDeepest> open_;
  std::size_t open_count_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity();
  std::uint32_t element_ = 0;
};

}  // namespace

ToolDistance evaluate_by_stretches(const CompiledTool& tool, double r_mm, double z_mm) {
  if (tool.stretches.empty() || tool.borders.empty()) return evaluate_brute_force(tool, r_mm, z_mm);
  return evaluate_element(tool, NearestElementSearch(tool, Vec2(r_mm, z_mm)).run(), r_mm, z_mm);
}

}  // namespace gouge
