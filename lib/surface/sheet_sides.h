#pragma once

#include <cstdint>
#include <optional>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Winding numbers on both sides of a surface at a point of it. Triangles that lie on each other there are one sheet.
struct SheetSides {
  int front = 0;             ///< on the side to which the normal points
  int back = 0;              ///< on the other side
  std::uint32_t lowest = 0;  ///< triangle of the sheet
};

/// Returns the winding numbers beside a point of a closed surface.
///
/// `normal`: unit, of a triangle at the point; `rounding_mm`: as rounding_of.
/// Requires a point farther than a few roundings from the edges of all triangles of its sheet.
/// Errors   Nothing where rounding decides the sides of several rays.
/// Cost     About O(log n) and what a ray meets.
[[nodiscard]] std::optional<SheetSides> find_sheet_sides(const BlockTree& tree, const Vec3& point, const Vec3& normal,
                                                         double rounding_mm);

}  // namespace gouge
