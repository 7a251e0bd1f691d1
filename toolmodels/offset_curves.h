#pragma once

#include <vector>

#include "toolmodels/profile.h"

// Functions that compute the curves at a given distance from a contour and the points where two curves meet. `unite`
// uses them.

namespace gouge::detail {

/// Returns the directed pieces of lines and circles of which the boundary of the offset body can consist. These are
/// each element moved out by `growth_mm`, and an arc about every convex corner. Parts of them may lie inside the offset
/// body, or on the other side of the axis. Growth 0 gives the elements unchanged.
/// Requires  verify_profile(profile).empty(), growth_mm >= 0.
[[nodiscard]] std::vector<ProfileElement> offset_curves(const Profile& profile, double growth_mm);

/// Returns points common to both curves, ends included, to within `slack_mm`; none if the curves overlap. Tangency
/// gives one point, or two within rounding of each other.
[[nodiscard]] std::vector<Vec2> meeting_points(const ProfileElement& c, const ProfileElement& d, double slack_mm);

/// Returns the points of a curve on the axis, r = 0.
[[nodiscard]] std::vector<Vec2> axis_points(const ProfileElement& curve, double slack_mm);

/// Returns the position of a point along a curve: in mm on a segment, in radians on an arc, 0 at the start. It is
/// negative before the start.
[[nodiscard]] double length_along(const ProfileElement& curve, const Vec2& point);
[[nodiscard]] double curve_length(const ProfileElement& curve);

/// Returns whether the curve comes within `slack_mm` of the point, ends included.
[[nodiscard]] bool passes(const ProfileElement& curve, const Vec2& point, double slack_mm);

/// Returns the middle of a curve.
[[nodiscard]] Vec2 middle(const ProfileElement& curve);

}  // namespace gouge::detail
