#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lib/geom/vec.h"

// Closed solids as triangle soups, counter-clockwise seen from outside. Neighbouring triangles share whole
// edges with identical coordinates, so that welding gives a closed manifold.

namespace gouge::samples {

using Triangle = std::array<Vec3, 3>;
using Solid = std::vector<Triangle>;
using Ring = std::vector<Vec3>;  ///< closed polygon, counter-clockwise seen from above

/// Adds the quad a b c d (in that order around) as two triangles.
void add_quad(Solid& solid, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Adds the strip between two rings of equal size, `upper` lying above `lower`; faces look away from the
/// inside of the rings, or towards it when `faces_inward`.
void add_strip(Solid& solid, const Ring& upper, const Ring& lower, bool faces_inward = false);

/// Adds a fan from `center` over `ring`, looking up, or down when `faces_down`.
void add_cap(Solid& solid, const Vec3& center, const Ring& ring, bool faces_down = false);

/// The union of the cells of a grid for which `is_solid(i, j, k)`; cell i spans x[i] to x[i + 1].
[[nodiscard]] Solid make_grid_solid(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                                    const std::function<bool(int, int, int)>& is_solid);

/// An axis-parallel box of 12 triangles.
[[nodiscard]] Solid make_box(const Vec3& low, const Vec3& high);

/// Bytes of a binary STL file (little endian); normals are left zero, as the format allows.
[[nodiscard]] std::string stl_bytes(const Solid& solid);

}  // namespace gouge::samples
