#pragma once

#include <array>

#include "lib/geom/vec.h"

// Predicates of triangles that double precision can prove. Each result "true" is proved, whatever rounding did
// (docs/method/self_intersections.md, section 3); "false" states nothing, and exact arithmetic must decide. Lengths of
// one unit and frame, each coordinate finite and at most 1e30. Cost: some 20 to 300 operations.

namespace gouge::detail {

/// Returns whether the corners do not lie on one line.
[[nodiscard]] bool surely_has_area(const std::array<Vec3, 3>& t);

/// Returns whether the triangles surely share no point. Corners in any order.
[[nodiscard]] bool are_surely_apart(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

/// Returns whether the triangles surely share no point but their first corner, which is the same. Both must have area.
[[nodiscard]] bool share_surely_one_corner(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

/// Returns whether the triangles surely share no point but the side between their first two corners, which are the same
/// in this order. Both must have area.
[[nodiscard]] bool share_surely_one_side(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

enum class RayMeeting { none, once, unknown };

/// Returns whether the ray from p on along a coordinate axis (0 to 2), to infinity, meets the triangle. Proved are
/// `none` and `once`, through its inside.
[[nodiscard]] RayMeeting meet_ray(const std::array<Vec3, 3>& t, const Vec3& p, int axis);

}  // namespace gouge::detail
