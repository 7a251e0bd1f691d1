#pragma once

#include <span>

#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// How often the surface winds around `point_part`: the sum of the triangles' signed solid angles over 4 pi.
///
/// Units    mm, part coordinates.
/// Ensures  (1) For a surface whose every edge is used equally often in both directions (what
///          MeshFindings::is_watertight says) and a point off the surface it is a whole number up to about
///          1e-15 (sqrt(n) + size / distance to the surface): 1 inside an outward closed solid, 0 outside,
///          0 in a cavity, -1 inside an inside-out one.
///          (2) For other surfaces it is a fraction that changes continuously; only a hint.
///          (3) Summed in triangle order in one thread: always the same bits.
/// Degenerate  A triangle with the point in its plane adds 0 when the point is outside it or on its rim, half
///          of the sphere with either sign when it is inside; never NaN.
/// Cost     O(n), one atan2 a triangle (100,000 triangles: about 5 ms).
/// Source   A. Van Oosterom, J. Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed. Eng.
///          BME-30 (1983) 125-126; as a test for inside: A. Jacobson et al., Robust inside-outside
///          segmentation using generalized winding numbers, ACM Trans. Graph. 32 (2013).
[[nodiscard]] double winding_number(const IndexedMesh& mesh, const Vec3& point_part);

/// Whether the surfaces together wind around the point: the sum of their winding numbers is nearer to +-1, or beyond
/// it, than to 0. Exact for closed surfaces and a point off them, whichever way they face; a hint for others.
/// Cost  that of winding_number.
[[nodiscard]] bool is_inside(std::span<const IndexedMesh> meshes, const Vec3& point_part);

/// Signed solid angle of triangle abc seen from `point`: positive from the side its corners run clockwise
/// (from behind, that is from inside a closed outward mesh). In [-2 pi, 2 pi].
[[nodiscard]] double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point);

}  // namespace gouge
