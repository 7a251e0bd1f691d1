#pragma once

#include <optional>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The points x with |x - through - height * direction| <= radius, where height = direction . (x - through) is in [low,
/// high].
struct Column {
  Vec3 through = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  ///< unit
  double radius_mm = 0;
  double low_mm = 0, high_mm = 0;
};

/// Returns a height that no triangle of the tree exceeds in the column; nothing if it is above `max_mm`. It is at least
/// column.low_mm. A node whose bound is at most `cutoff_mm` is not opened; the bound is taken as its height. Requires
/// cutoff_mm <= max_mm.
///
/// Ensures  For a triangle over the whole column the height is exact up to rounding, unless the height is the bound of
///          a node that was not opened. The height of any other triangle is bounded by the lower of two heights: its
///          highest corner, and its plane within the column.
/// Cost     About O(log n) while the column is no wider than its distance from triangles that reach above `max_mm`.
[[nodiscard]] std::optional<double> highest_in_column(const BlockTree& tree, const Column& column, double cutoff_mm,
                                                      double max_mm);

}  // namespace gouge
