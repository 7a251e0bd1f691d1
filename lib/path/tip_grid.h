#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// Finds points near a place, in time that does not grow with their number.
class TipGrid {
 public:
  /// Points that are nearer than `near_mm` are found.
  explicit TipGrid(double near_mm);

  void add(const Vec3& tip, std::size_t index);
  /// Returns the indices of points within near_mm, at most `max_count` of them, in rising order. The cost is that of the
  /// points in the eight nearest cells, until so many are found.
  [[nodiscard]] std::vector<std::size_t> find(const Vec3& tip, std::size_t max_count) const;

 private:
  struct Point {
    Vec3 tip;
    std::size_t index;
  };
  [[nodiscard]] std::uint64_t cell_of(const Vec3& tip) const;

  double near_mm_, cell_mm_;
  std::unordered_map<std::uint64_t, std::vector<Point>> cells_;  // by a hash of the cell: others may share it
};

}  // namespace gouge
