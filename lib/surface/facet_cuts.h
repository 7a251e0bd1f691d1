#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// A triangle divided into convex pieces.
struct FacetPieces {
  std::vector<Vec3> points;  ///< the corners of the triangle come first
  /// The corners of each piece, as indices of points, in the triangle's orientation. Neighbours share points.
  std::vector<std::vector<std::size_t>> polygons;
};

/// Cuts the triangle so that no segment runs through the inside of a piece.
///
/// Shape    Segments are in the triangle's plane, mm. Parts beyond the triangle are ignored.
/// Requires a triangle with area.
/// Ensures  The pieces cover the triangle except for slivers no wider than `rounding_mm`. They lie in its plane to
///          about that length.
/// Cost     O(k log k) for k segments that do not cross, at most O(k^2) pieces.
[[nodiscard]] FacetPieces cut_facet(const std::array<Vec3, 3>& triangle, std::span<const std::array<Vec3, 2>> segments,
                                    double rounding_mm);

}  // namespace gouge
