#pragma once

#include "lib/base/result.h"
#include "toolmodels/profile.h"

namespace gouge {

/// Returns the contour of all places that a body of revolution takes while it tilts about the tip, the origin, by at most
/// `max_tilt_rad` in any direction. The union is a body of revolution again. In polar coordinates about the tip (distance
/// and angle from the axis) its half section holds every angle that differs by at most `max_tilt_rad` from one of the
/// body. Its contour consists of the elements turned by that angle either way, and of arcs about the tip.
///
/// Requires  The result of verify_profile is empty, or the profile has no elements; 0 <= max_tilt_rad < pi / 4.
/// Ensures   (1) The result of verify_profile is empty, unless there are no elements. (2) The contour lies within 1e-9 of
///           the body's size of the true union; a hollow that no tilt leaves open is solid. (3) A tilt of 0 returns the
///           profile.
/// Errors    Code tool-not-closed: the union has no contour from the axis to the axis.
/// Cost      Quadratic in the number of elements.
/// Proof     docs/method/machine.md, section "Tolerance tube".
[[nodiscard]] Result<Profile> sweep_tilts(const Profile& profile, double max_tilt_rad);

}  // namespace gouge
