#pragma once

#include <vector>

#include "toolmodels/profile.h"

// The curves at a given distance from a contour, and where two curves meet: what `unite` is made of.

namespace gouge::detail {

/// Returns the directed pieces of lines and circles of which the boundary of the offset body can consist. They are each
/// element moved out by `growth_mm`, and an arc about every convex corner. Parts of them lie deeper than `growth_mm` in
/// the offset body, or on the far side of the axis. Growth 0 gives the elements as they are.
/// Requires  verify_profile(profile).empty(), growth_mm >= 0.
[[nodiscard]] std::vector<ProfileElement> offset_curves(const Profile& profile, double growth_mm);

/// Returns points common to both curves, ends included, to within `slack_mm`; where they run along one another none.
/// Tangency gives one point, or two within rounding of each other.
[[nodiscard]] std::vector<Vec2> meeting_points(const ProfileElement& c, const ProfileElement& d, double slack_mm);

/// Returns points of a curve on the axis, r = 0.
[[nodiscard]] std::vector<Vec2> axis_points(const ProfileElement& curve, double slack_mm);

/// Returns how far along a curve a point lies: mm on a segment, radians on an arc, 0 at the start. Negative before
/// it.
[[nodiscard]] double length_along(const ProfileElement& curve, const Vec2& point);
[[nodiscard]] double curve_length(const ProfileElement& curve);

/// Returns whether the curve passes the point within `slack_mm`, ends included.
[[nodiscard]] bool passes(const ProfileElement& curve, const Vec2& point, double slack_mm);

/// Returns the middle of a curve.
[[nodiscard]] Vec2 middle(const ProfileElement& curve);

}  // namespace gouge::detail
