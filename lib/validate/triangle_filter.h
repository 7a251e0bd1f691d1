#pragma once

#include <array>

#include "lib/geom/vec.h"

// Tests of triangles that double precision can prove. A result "true" is proved for any rounding
// (docs/method/self_intersections.md, section 3). A result "false" proves nothing; exact arithmetic must decide. All
// lengths have one unit and one frame; each coordinate is finite and at most 1e30. Cost: about 20 to 300 operations.

namespace gouge::detail {

/// Returns whether the corners certainly do not lie on one line.
[[nodiscard]] bool surely_has_area(const std::array<Vec3, 3>& t);

/// Returns whether the triangles certainly share no point. Corners in any order.
[[nodiscard]] bool are_surely_apart(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

/// Returns whether the triangles certainly share only their first corner, which is the same. Both must have area.
[[nodiscard]] bool share_surely_one_corner(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

/// Returns whether the triangles certainly share only the side between their first two corners. These corners are the
/// same, in this order. Both triangles must have area.
[[nodiscard]] bool share_surely_one_side(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

enum class RayMeeting { none, once, unknown };

/// Returns whether the infinite ray from p along a coordinate axis (0 to 2) meets the triangle. The results `none` and
/// `once` (through the interior) are proved.
[[nodiscard]] RayMeeting meet_ray(const std::array<Vec3, 3>& t, const Vec3& p, int axis);

}  // namespace gouge::detail
