#pragma once

#include <array>
#include <cstdint>

#include "lib/geom/vec.h"

namespace gouge {

/// Indices of a cell, or of a corner of cells, along the axes.
using GridIndex = std::array<std::int32_t, 3>;

/// Returns one number for indices from -1 to 2^21 - 2, in the order of z, y, x.
[[nodiscard]] constexpr std::uint64_t grid_key(const GridIndex& at) {
  constexpr int kBits = 21;
  return (static_cast<std::uint64_t>(at[2] + 1) << (2 * kBits)) | (static_cast<std::uint64_t>(at[1] + 1) << kBits) |
         static_cast<std::uint64_t>(at[0] + 1);
}
[[nodiscard]] GridIndex grid_index(std::uint64_t key);

/// Spreads keys over the places of a hash table (SplitMix64 by Steele, Lea and Flood).
struct GridHash {
  std::size_t operator()(std::uint64_t key) const {
    std::uint64_t z = key + 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>(z ^ (z >> 31U));
  }
};

/// Equal cells about a box. The planes of the box pass through the middles of cells, and the outermost cells on all sides
/// are beyond them. mm.
struct CellGrid {
  static constexpr std::int32_t kMaxCells = 1 << 20;  ///< along one axis

  Vec3 origin = Vec3::Zero(), size = Vec3::Ones();  ///< of corner 0, and of one cell
  GridIndex count{};                                ///< number of cells

  /// Requires at most kMaxCells - 3 cells along an axis.
  [[nodiscard]] static CellGrid about(const Vec3& low, const Vec3& high, double cell_mm);

  [[nodiscard]] Vec3 corner(const GridIndex& at) const { return origin + Vec3(at[0], at[1], at[2]).cwiseProduct(size); }
  [[nodiscard]] bool has_cell(const GridIndex& at) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (at[k] < 0 || at[k] >= count[k]) return false;
    return true;
  }
};

/// Returns corner `k` of a cell; bit 0, 1, 2 of k is its side along x, y, z.
[[nodiscard]] constexpr GridIndex corner_of(const GridIndex& cell, unsigned k) {
  return {cell[0] + static_cast<std::int32_t>(k & 1U), cell[1] + static_cast<std::int32_t>((k >> 1U) & 1U),
          cell[2] + static_cast<std::int32_t>((k >> 2U) & 1U)};
}

[[nodiscard]] constexpr GridIndex moved(GridIndex at, std::size_t axis, std::int32_t by) {
  at[axis] += by;
  return at;
}

}  // namespace gouge
