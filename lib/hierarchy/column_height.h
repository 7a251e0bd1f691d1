#pragma once

#include <optional>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The points x with |x - through - height * direction| <= radius, height = direction . (x - through) in [low, high].
struct Column {
  Vec3 through = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  ///< unit
  double radius_mm = 0;
  double low_mm = 0, high_mm = 0;
};

/// Returns a height that no triangle of the tree exceeds in the column; nothing when it is above `max_mm`. It is at
/// least column.low_mm. Below `cutoff_mm` (no more than max_mm) no effort is made to find a lower one.
///
/// Ensures  For a triangle over all of the column the height is exact up to rounding, if a node of the tree was not low
///          enough. Others are taken as high as their highest corner, or as their plane in the column.
/// Cost     About O(log n) while the column is no wider than its distance from triangles that reach above `max_mm`.
[[nodiscard]] std::optional<double> highest_in_column(const BlockTree& tree, const Column& column, double cutoff_mm,
                                                      double max_mm);

}  // namespace gouge
