#pragma once

#include <cstddef>
#include <functional>

#include "lib/mesh/indexed_mesh.h"

// Generated solids: a height over the plane with walls and a floor below it, tessellated at any size. Corners
// are rounded to single precision, so that an STL file and engines with floats see the very same triangles.

namespace gouge::bench {

using Height = std::function<double(double x_mm, double y_mm)>;

/// A closed block over the square [0, side]^2, floor at z = 0, from equal squares cut into two triangles.
[[nodiscard]] IndexedMesh make_block(const Height& height, double side_mm, std::size_t triangles);

/// A closed round solid over the disc of the radius about the origin, floor at z = 0, from rings and spokes.
[[nodiscard]] IndexedMesh make_disc(const Height& height, double radius_mm, std::size_t triangles);

/// Outward unit normal of the surface z = height(x, y).
[[nodiscard]] Vec3 normal_at(const Height& height, double x_mm, double y_mm);

}  // namespace gouge::bench
