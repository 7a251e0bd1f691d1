#include "toolmodels/trace_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "lib/tool/evaluate.h"
#include "toolmodels/bsp.h"
#include "toolmodels/elements.h"
#include "toolmodels/voronoi.h"

namespace gouge {

namespace {

struct Ray {
  Vec2 from, direction;
};

Vec2 turned(const Vec2& u, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * u.x() - s * u.y(), s * u.x() + c * u.y()};
}

// Returns the place of ray i. Rays are closer to each other near the ends, where a bisector may run almost along them.
double share(int i, int steps) { return 0.5 * (1 - std::cos(std::numbers::pi * i / steps)); }

// Reduces the number of steps if there are many elements, because each is then small in the picture.
int steps_of(int usual, std::size_t elements) {
  constexpr int kUsualElements = 64, kFewest = 4;
  return std::max(kFewest, usual * kUsualElements / std::max(kUsualElements, static_cast<int>(elements)));
}

double angle_between(const Vec2& u, const Vec2& v) { return std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)); }

class Tracer {
 public:
  Tracer(const CompiledTool& tool, const Vec2& low, const Vec2& high) : tool_(tool), low_(low), high_(high) {
    slack_ = Tolerance::kSamePoint_mm * std::max({tool.r_max_mm, tool.z_max_mm, -tool.z_min_mm});
  }

  std::vector<TracedRegion> trace() {
    for (std::uint32_t i = 0; i < tool_.elements.size(); ++i)
      for (const bool is_inside : {false, true}) add_region(i, is_inside);
    return std::move(regions_);
  }

 private:
  void add_region(std::uint32_t index, bool is_inside) {
    const BoundaryElement& e = tool_.elements[index];
    if (e.kind == ElementKind::vertex && e.is_reflex != is_inside) return;
    TracedRegion region;
    region.element = index;
    region.is_inside = is_inside;
    for (const Ray& ray : rays(index, is_inside ? -1 : 1)) {
      const double limit = length_in_window(ray);
      if (limit <= 0) continue;
      const double reach = length_in_region(ray, limit);
      region.near_points.push_back(ray.from);
      region.far_points.emplace_back(ray.from + reach * ray.direction);
      region.is_bisector.push_back(reach < limit - slack_);
    }
    if (region.near_points.size() > 1) regions_.push_back(std::move(region));
  }

  std::vector<Ray> rays(std::uint32_t index, double sign) const {
    const BoundaryElement& e = tool_.elements[index];
    std::vector<Ray> list;
    if (e.kind == ElementKind::segment) {
      const int steps = steps_of(480, tool_.elements.size());
      for (int i = 0; i <= steps; ++i) list.push_back({e.a + share(i, steps) * (e.b - e.a), sign * e.normal});
      return list;
    }
    const int steps = steps_of(120, tool_.elements.size());
    const Vec2 first = e.kind == ElementKind::arc ? normal_at(e, e.a) : normal_before(index);
    const Vec2 last = e.kind == ElementKind::arc ? normal_at(e, e.b) : normal_after(index);
    const double sweep = angle_between(first, last);
    for (int i = 0; i <= steps; ++i) {
      const Vec2 normal = turned(first, sweep * share(i, steps));
      const double side = e.is_reflex ? -1 : 1;
      const Vec2 from = e.kind == ElementKind::arc ? Vec2(e.center + side * e.radius_mm * normal) : e.a;
      list.push_back({from, sign * normal});
    }
    return list;
  }

  Vec2 normal_before(std::uint32_t index) const {
    if (index > 0) return normal_at(tool_.elements[index - 1], tool_.elements[index].a);
    const Vec2 after = normal_after(index);
    return {-after.x(), after.y()};
  }
  Vec2 normal_after(std::uint32_t index) const {
    if (index + 1 < tool_.elements.size()) return normal_at(tool_.elements[index + 1], tool_.elements[index].a);
    const Vec2 before = normal_before(index);
    return {-before.x(), before.y()};
  }

  // Returns the length of a ray up to the border of the window; 0 if it starts outside.
  double length_in_window(const Ray& ray) const {
    constexpr double kNoSpeed = 1e-15;
    double length = 1e300;
    const auto limit = [&](double at, double speed, double low, double high) {
      if (at < low - slack_ || at > high + slack_) length = 0;
      if (speed > kNoSpeed) length = std::min(length, (high - at) / speed);
      if (speed < -kNoSpeed) length = std::min(length, (low - at) / speed);
    };
    limit(ray.from.x(), ray.direction.x(), 0, high_.x());
    limit(ray.from.y(), ray.direction.y(), low_.y(), high_.y());
    return std::max(0.0, length);
  }

  // Returns the length of the ray on which its own element is the nearest. From the point at which another element is
  // nearer, it stays nearer along the ray. So bisection finds that point.
  double length_in_region(const Ray& ray, double limit) const {
    const auto is_nearest = [&](double t) {
      const Vec2 q = ray.from + t * ray.direction;
      return std::abs(signed_distance_mm(tool_, std::max(0.0, q.x()), q.y())) >= t - slack_;
    };
    if (is_nearest(limit)) return limit;
    double low = 0, high = limit;
    for (int i = 0; i < 60 && high - low > 0.01 * slack_; ++i) {
      const double middle = 0.5 * (low + high);
      (is_nearest(middle) ? low : high) = middle;
    }
    return low;
  }

  const CompiledTool& tool_;
  Vec2 low_, high_;
  double slack_ = 0;
  std::vector<TracedRegion> regions_;
};

}  // namespace

std::vector<TracedRegion> trace_regions(const CompiledTool& tool, const Vec2& low, const Vec2& high) {
  return Tracer(tool, low, high).trace();
}

namespace {

constexpr std::uint32_t kFewElements = 4;

// Returns the corners of a rectangle around an element: its chord, moved out by the height of its arc.
std::array<Vec2, 4> corners_around(const BoundaryElement& e) {
  if (e.kind != ElementKind::arc) return {e.a, e.b, e.a, e.b};
  const Vec2 top = e.center + e.radius_mm * e.normal;
  const Vec2 rise = std::max(0.0, (top - e.a).dot(e.normal)) * e.normal;
  return {e.a, e.b, e.a + rise, e.b + rise};
}

class TreeMaker {
 public:
  explicit TreeMaker(const std::vector<BoundaryElement>& elements) : elements_(elements) {}

  std::vector<ContourStretch> make() {
    if (!elements_.empty()) add(0, static_cast<std::uint32_t>(elements_.size()));
    return std::move(stretches_);
  }

 private:
  void add(std::uint32_t first, std::uint32_t last) {
    const std::size_t index = stretches_.size();
    stretches_.push_back(box_of(first, last));
    if (last - first <= kFewElements) return;
    const std::uint32_t middle = first + (last - first) / 2;
    add(first, middle);
    stretches_[index].second = static_cast<std::uint32_t>(stretches_.size());
    add(middle, last);
  }

  [[nodiscard]] ContourStretch box_of(std::uint32_t first, std::uint32_t last) const {
    ContourStretch stretch;
    stretch.first = first;
    stretch.last = last;
    stretch.origin = elements_[first].a;
    const Vec2 chord = elements_[last - 1].b - stretch.origin;
    if (chord.norm() > 0) stretch.along = chord.normalized();
    stretch.low.setConstant(std::numeric_limits<double>::infinity());
    stretch.high = -stretch.low;
    for (std::uint32_t k = first; k < last; ++k) {
      for (const Vec2& corner : corners_around(elements_[k])) {
        const Vec2 away = corner - stretch.origin;
        const Vec2 place(stretch.along.dot(away), cross(stretch.along, away));
        stretch.low = stretch.low.cwiseMin(place);
        stretch.high = stretch.high.cwiseMax(place);
      }
    }
    return stretch;
  }

  const std::vector<BoundaryElement>& elements_;
  std::vector<ContourStretch> stretches_;
};

}  // namespace

std::vector<ContourStretch> make_contour_tree(const std::vector<BoundaryElement>& elements) {
  return TreeMaker(elements).make();
}

std::vector<DomainBorder> make_borders(const std::vector<BoundaryElement>& elements) {
  std::vector<DomainBorder> borders;
  for (const detail::DirectedLine& line : detail::make_domains(elements).lines) {
    const bool is_cusp =
        !borders.empty() && borders.back().direction.dot(line.direction) < -1 + Tolerance::kFewRoundings;
    if (is_cusp) return {};
    borders.push_back({line.through, line.direction, 0});
  }
  return borders;
}

CompiledTool make_contour_solid(const Profile& profile) {
  CompiledTool solid;
  solid.elements = make_elements(profile);
  if (solid.elements.size() <= kMaxBspElements) return solid;
  solid.borders = make_borders(solid.elements);
  solid.stretches = make_contour_tree(solid.elements);
  return solid;
}

}  // namespace gouge
