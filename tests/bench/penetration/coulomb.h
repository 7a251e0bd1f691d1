#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

/// `count` axes whose 2 * count ends lie on the unit sphere with little Coulomb energy: steepest descent from
/// a spiral, steps halved when the energy grows, until a step no longer lowers it by a relative 1e-13.
///
/// Ensures  unit axes; for 3 axes the cube's faces, for 6 the icosahedron's corners, up to a rotation. Deviates the
///          energy is minimised among sets that are their own mirror image; free charges of k = 8 or 20 reach a little
///          less, but have no interval test (lib/kdop/directions.h).
/// Source   thesis 6.1.2, [Edmundson 92].
[[nodiscard]] std::vector<Vec3> spread_axes(std::size_t count);

/// Sum of 1 / distance over all pairs of the axes' ends, both ends of each counted.
[[nodiscard]] double coulomb_energy(std::span<const Vec3> axes);

}  // namespace gouge
