#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lib/geom/vec.h"

// The directions of a k-DOP: k half spaces in k / 2 opposite pairs, kept as k / 2 axes with an interval each.
// Two volumes over the same directions are apart as soon as their intervals are apart along one axis, which
// needs both ends of every axis: sets that are not their own mirror image (the tetrahedron, an odd k) have no
// such test and are not offered.

namespace gouge {

enum class DirectionFamily {
  cube,      ///< faces, corners and edges of a cube: k = 6, 14, 18, 26 (thesis 2.3.2.6)
  platonic,  ///< face normals of octahedron 8, dodecahedron 12, icosahedron 20 (thesis 6.1.2)
  coulomb,   ///< spread evenly by minimising the Coulomb energy: any even k from 6 to 128 (thesis 6.1.2)
};

struct DirectionSet {
  std::vector<Vec3> axes;  ///< unit
  [[nodiscard]] std::size_t k() const { return 2 * axes.size(); }
};

/// Nothing when the family has no set of that k. The same bits on every call.
/// Cost  constant for cube and platonic; O(k^2) an iteration, a few thousand iterations, for coulomb.
[[nodiscard]] std::optional<DirectionSet> make_directions(DirectionFamily family, std::size_t k);

}  // namespace gouge
