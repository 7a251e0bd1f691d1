#pragma once

#include <span>

#include "lib/geom/vec.h"

namespace gouge {

/// Normal at `vertex` of the paraboloid z = a x + b y + c x^2 + d x y + e y^2 through it that fits
/// `neighbours` best in least squares, z along `guess`; on the side of `guess`.
///
/// Degenerate  fewer than five neighbours: the flattest of the fitting paraboloids; neighbours on one line
///             through the vertex or none: `guess`.
/// Ensures     on a smooth surface with neighbours at distance h the error is O(h^2) (tests: sphere, torus).
/// Source      thesis 4.5.2.2, [Marciniak 01].
[[nodiscard]] Vec3 paraboloid_normal(const Vec3& vertex, std::span<const Vec3> neighbours, const Vec3& guess);

}  // namespace gouge
