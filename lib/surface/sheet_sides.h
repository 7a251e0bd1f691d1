#pragma once

#include <cstdint>
#include <optional>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Winding numbers on both sides of a surface at one of its points. Triangles that lie on each other there are one
/// sheet.
struct SheetSides {
  int front = 0;             ///< winding number on the side to which the normal points
  int back = 0;              ///< winding number on the other side
  std::uint32_t lowest = 0;  ///< lowest triangle of the sheet
};

/// Returns the winding numbers on both sides of a point of a closed surface.
///
/// `normal` is the unit normal of a triangle at the point; `rounding_mm` is the result of rounding_of.
/// Requires a point farther than a few roundings from the edges of all triangles of its sheet.
/// Errors   Returns nothing if the results of several rays depend on rounding.
/// Cost     About O(log n) plus the number of triangles that a ray meets.
[[nodiscard]] std::optional<SheetSides> find_sheet_sides(const BlockTree& tree, const Vec3& point, const Vec3& normal,
                                                         double rounding_mm);

}  // namespace gouge
