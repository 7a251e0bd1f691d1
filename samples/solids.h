#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lib/geom/vec.h"

// Closed solids as triangle soups, counter-clockwise seen from outside. Neighbouring triangles share whole edges with
// identical coordinates, so that welding gives a closed manifold.

namespace gouge::samples {

using Triangle = std::array<Vec3, 3>;
using Solid = std::vector<Triangle>;
using Ring = std::vector<Vec3>;  ///< closed polygon, counter-clockwise seen from above

/// Adds the quadrilateral with the corners a, b, c, d, in this order around it, as two triangles.
void add_quad(Solid& solid, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Adds the strip between two rings of equal size, with `upper` above `lower`. Faces look away from the inside of the
/// rings, or towards it if `faces_inward`.
void add_strip(Solid& solid, const Ring& upper, const Ring& lower, bool faces_inward = false);

/// Adds a fan from `center` over `ring` that looks up, or down if `faces_down`.
void add_cap(Solid& solid, const Vec3& center, const Ring& ring, bool faces_down = false);

/// Returns the union of the cells of a grid for which `is_solid(i, j, k)`; cell i spans x[i] to x[i + 1].
[[nodiscard]] Solid make_grid_solid(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                                    const std::function<bool(int, int, int)>& is_solid);

/// Returns an axis-parallel box of 12 triangles.
[[nodiscard]] Solid make_box(const Vec3& low, const Vec3& high);

/// Returns the bytes of a binary STL file (little endian). Normals are zero, as the format allows.
[[nodiscard]] std::string stl_bytes(const Solid& solid);

}  // namespace gouge::samples
