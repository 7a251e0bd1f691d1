#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

struct DepthBody;

/// Cells over a solid. They give the side of most points at once, and show where nothing can be deeper than the depth
/// of its volumes.
///
/// A cell whose centre lies within half its diagonal of the surface has no point farther from the surface than the
/// diagonal. While that is at most the depth, nothing in it is deeper. Any other cell holds no surface and is all
/// inside or all outside, and so are cells that share a face with it.
class DepthGrid {
 public:
  enum class Cover : std::uint8_t {
    outside,  ///< certainly
    inside,   ///< certainly, at any depth
    shallow,  ///< either; if inside, not deeper than the depth
    ask,      ///< either, at any depth: the cells are too coarse here
  };

  using Cell = std::array<int, 3>;

  DepthGrid() = default;  ///< empty: every point needs a query
  /// Requires a solid. At most about 4 million cells. Cost O(triangles and cells).
  explicit DepthGrid(const DepthBody& body);

  [[nodiscard]] Cover at(const Vec3& point) const { return result(cell_of(point)); }

  /// Returns the cell of a point; cell_count(), which is outside, for points out of the body's box.
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
  std::vector<std::uint8_t> packed_;  ///< an entry takes two bits
};

}  // namespace gouge
