#pragma once

#include <cstddef>
#include <vector>

#include "lib/geom/vec.h"

// The directions of a k-DOP: k half spaces in k / 2 opposite pairs, stored as k / 2 axes with one interval each. Two
// volumes over the same directions are disjoint if their intervals are disjoint along one axis. That test needs both
// ends of every axis. Sets that are not their own mirror image (the tetrahedron, an odd k) have no such test and are
// not provided.

namespace gouge {

struct DirectionSet {
  std::vector<Vec3> axes;  ///< unit
  [[nodiscard]] std::size_t k() const { return 2 * axes.size(); }
};

/// Returns the directions of faces, corners and edges of a cube (thesis 2.3.2.6). Requires k of 6, 14, 18 or 26. The
/// result has the same bits at every call.
[[nodiscard]] DirectionSet cube_directions(std::size_t k);

}  // namespace gouge
