#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/stock/excess_search.h"

namespace gouge {

/// Returns the place of each piece, numbered from 0 in the order of their first pieces. Pieces are in one place if cells of
/// the space that hold them touch, cell by cell. A cell is a cube of side `cell_mm`.
///
/// Cost  O(n log n) for n cells with pieces.
[[nodiscard]] std::vector<std::uint32_t> places_of(std::span<const LeftPiece> pieces, double cell_mm);

}  // namespace gouge
