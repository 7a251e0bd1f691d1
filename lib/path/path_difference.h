#pragma once

#include <cstddef>
#include <optional>

#include "lib/path/toolpath.h"

namespace gouge {

/// Distances of the positions of one path from the motions of another.
struct PathDifference {
  std::size_t positions = 0;  ///< feed positions that were compared
  double tip_mm = 0;          ///< largest distance of a tip from the nearest motion
  double axis_rad = 0;        ///< largest angle between the axes there
  /// The position of the largest value, and the nearest motion; kNone: there is no position.
  std::size_t tip_move = kNone, tip_other = kNone, axis_move = kNone, axis_other = kNone;
};

/// Measures the end of each checked feed of `path` against the feeds of `other`, along their arcs and splines. The nearest
/// motion is that whose tip is nearest; an angle of 1 rad counts as `height_mm`. Among equally near ones it is the next
/// after the one before. None: a path has no feed that is checked.
/// Cost     O(moves) for paths in the same order, at worst the product of both numbers of moves.
[[nodiscard]] std::optional<PathDifference> measure_difference(const Toolpath& path, const Toolpath& other,
                                                               double height_mm);

}  // namespace gouge
