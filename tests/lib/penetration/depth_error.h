#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/surface/surface.h"
#include "tests/lib/penetration/random_points.h"

// How far depths that were found are from the true ones. Header only.

namespace gouge {

struct Error {
  std::size_t inside = 0, missed = 0, false_alarms = 0;
  double largest_mm = 0, sum_mm = 0;
};

/// Depths that were found, negative where none was, against the nearest facets.
inline Error error_of(const DepthBody& body, const std::vector<Vec3>& points, const std::vector<double>& found_mm) {
  Error error;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto foot = body.surface.closest_point(points[i]);
    if (foot->distance_mm < 1e-6) continue;
    if (!foot->is_inside) {
      error.false_alarms += found_mm[i] >= 0 ? 1U : 0U;
      continue;
    }
    ++error.inside;
    error.missed += found_mm[i] < 0 ? 1U : 0U;
    if (found_mm[i] < 0) continue;
    const double off = std::abs(found_mm[i] - foot->distance_mm);
    error.largest_mm = std::max(error.largest_mm, off);
    error.sum_mm += off;
  }
  return error;
}

/// 4,000 random shallow points.
inline std::vector<Vec3> shallow_points(const IndexedMesh& mesh, double depth_mm) {
  RandomPoints random(mesh, 0.8 * depth_mm, 11);
  std::vector<Vec3> points;
  for (int i = 0; i < 4000; ++i) points.push_back(random.next());
  return points;
}

}  // namespace gouge
