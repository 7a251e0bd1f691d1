#include "lib/clash/distance_bound.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/geom/point_triangle.h"

namespace gouge {
namespace {

constexpr int kMixes = 3;         // facets mixed with the best one after another
constexpr int kWeightSteps = 24;  // of the search for each weight

/// Distances of the hull's points to one facet, or a weighted mean of several.
using Distances = std::array<double, kMostHullPoints>;

double largest(const Distances& d, std::size_t count) {
  return *std::max_element(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(count));
}

Distances mixed(const Distances& a, const Distances& b, double weight) {
  Distances d;
  for (std::size_t v = 0; v < d.size(); ++v) d[v] = (1 - weight) * a[v] + weight * b[v];
  return d;
}

/// The weight of `b` with the smallest largest mean: that is convex in the weight.
double best_weight(const Distances& a, const Distances& b, std::size_t count) {
  double low = 0, high = 1;
  for (int i = 0; i < kWeightSteps; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    const bool is_left_better = largest(mixed(a, b, left), count) < largest(mixed(a, b, right), count);
    (is_left_better ? high : low) = is_left_better ? right : left;
  }
  return 0.5 * (low + high);
}

}  // namespace

double greatest_distance_mm(const Surface& surface, std::span<const Vec3> points,
                            std::span<const std::uint32_t> facets) {
  std::array<Distances, kMostHullPoints + 1> rows{};
  const std::size_t count = std::min(facets.size(), rows.size());
  std::size_t best = 0;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t v = 0; v < points.size(); ++v)
      rows[k][v] = std::sqrt(closest_on_triangle(points[v], surface.corners(facets[k])).distance2_mm2);
    if (largest(rows[k], points.size()) < largest(rows[best], points.size())) best = k;
  }
  Distances now = rows[best];
  double least = largest(now, points.size());
  for (int mix = 0; mix < kMixes && count > 1; ++mix) {
    Distances next = now;
    double next_least = least;
    for (std::size_t k = 0; k < count; ++k) {
      const Distances tried = mixed(now, rows[k], best_weight(now, rows[k], points.size()));
      if (!(largest(tried, points.size()) < next_least)) continue;
      next = tried;
      next_least = largest(tried, points.size());
    }
    if (!(next_least < least)) break;
    now = next;
    least = next_least;
  }
  return least;
}

}  // namespace gouge
