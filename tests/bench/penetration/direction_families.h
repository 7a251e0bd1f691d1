#pragma once

#include <cstddef>
#include <optional>

#include "lib/kdop/directions.h"

namespace gouge {

/// The thesis's other sets of directions beside the cube's, for its tables: no program uses them.
enum class DirectionFamily {
  platonic,  ///< face normals of octahedron 8, dodecahedron 12, icosahedron 20 (thesis 6.1.2)
  coulomb,   ///< spread evenly by minimising the Coulomb energy: any even k from 6 to 128 (thesis 6.1.2)
};

/// Nothing when the family has no set of that k. The same bits on every call.
/// Cost  constant for platonic; O(k^2) an iteration, a few thousand iterations, for coulomb.
[[nodiscard]] std::optional<DirectionSet> make_directions(DirectionFamily family, std::size_t k);

}  // namespace gouge
