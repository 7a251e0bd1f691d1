#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// A triangle in convex pieces.
struct FacetPieces {
  std::vector<Vec3> points;  ///< the triangle's corners first
  /// Each the corners of a piece, numbers of points, in the triangle's sense of turning. Neighbours share points.
  std::vector<std::vector<std::size_t>> polygons;
};

/// Returns the triangle cut so that no segment runs through the inside of a piece.
///
/// Shape    Segments in the triangle's plane, mm; parts beyond the triangle are left out.
/// Requires a triangle with area.
/// Ensures  The pieces cover the triangle but for slivers no wider than `rounding_mm`; in the plane to about that.
/// Cost     O(k log k) for k segments that do not cross, at most O(k^2) pieces.
[[nodiscard]] FacetPieces cut_facet(const std::array<Vec3, 3>& triangle, std::span<const std::array<Vec3, 2>> segments,
                                    double rounding_mm);

}  // namespace gouge
