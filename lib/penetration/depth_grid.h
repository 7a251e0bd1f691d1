#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

struct DepthBody;

/// Cells over a solid. They give the side of most points at once, and show where no point can be deeper than the depth
/// of its volumes.
///
/// Let the centre of a cell be at most half its diagonal from the surface. Then no point of the cell is farther from
/// the surface than the diagonal. While the diagonal is at most the depth, no point in the cell is deeper. Any other
/// cell contains no surface and is completely inside or outside. Cells that share a face with it, and contain no
/// surface either, are on the same side.
class DepthGrid {
 public:
  enum class Cover : std::uint8_t {
    outside,  ///< all points are outside
    inside,   ///< all points are inside, at any depth
    shallow,  ///< inside or outside; if inside, no deeper than the depth
    ask,      ///< inside or outside, at any depth: the cells are too coarse here
  };

  using Cell = std::array<int, 3>;

  DepthGrid() = default;  ///< an empty grid, with which every point needs a search
  /// Builds the grid. Requires a solid. It has at most about 4 million cells. Cost O(triangles and cells).
  explicit DepthGrid(const DepthBody& body);

  [[nodiscard]] Cover at(const Vec3& point) const { return result(cell_of(point)); }

  /// Returns the cell of a point; cell_count() for points out of the body's box, which are outside.
  [[nodiscard]] std::size_t cell_of(const Vec3& point) const;
  [[nodiscard]] std::size_t cell_count() const { return cell_count_; }
  [[nodiscard]] double cell_mm() const { return cell_mm_; }
  [[nodiscard]] const Cell& counts() const { return counts_; }
  [[nodiscard]] std::size_t index(const Cell& cell) const;
  [[nodiscard]] Vec3 corner(const Cell& cell) const { return low_ + cell_mm_ * Vec3(cell[0], cell[1], cell[2]); }
  [[nodiscard]] Cover result(std::size_t cell) const {
    return packed_.empty() ? Cover::ask : static_cast<Cover>((packed_[cell / 4] >> (cell % 4 * 2)) & 3U);
  }

 private:
  [[nodiscard]] Vec3 centre(const Cell& cell) const;
  void mark_surface(const DepthBody& body, std::vector<std::uint8_t>& is_near) const;
  void fill(const DepthBody& body, const std::vector<std::uint8_t>& is_near, std::vector<Cover>& results);

  Vec3 low_ = Vec3::Zero();
  double cell_mm_ = 0, per_mm_ = 0;
  Cell counts_{0, 0, 0};
  std::size_t cell_count_ = 0;
  std::vector<std::uint8_t> packed_;  ///< each entry takes two bits
};

}  // namespace gouge
