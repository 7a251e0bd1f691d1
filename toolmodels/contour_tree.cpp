#include "toolmodels/contour_tree.h"

#include <algorithm>
#include <array>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/geom/cross.h"
#include "toolmodels/voronoi.h"

namespace gouge {
namespace {

constexpr std::uint32_t kFewElements = 4;

// The corners of a rectangle around an element: its chord, moved out by the height of its arc.
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

}  // namespace gouge
