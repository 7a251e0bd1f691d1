#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lib/geom/pose.h"

namespace gouge {

/// A correction of one move. Poses in mm and part coordinates, as in the Toolpath.
struct PathChange {
  std::size_t move = 0;
  std::optional<Pose> new_end;
  std::vector<Pose> inserted_before;  ///< positions to visit, in this order, before the move's end
  /// An arc or spline becomes straight moves through `inserted_before` to the end.
  bool is_straightened = false;
};

}  // namespace gouge
