#pragma once

#include <vector>

#include "lib/base/result.h"
#include "toolmodels/profile.h"

// The union of bodies, each offset by its own clearance (the solid of revolution plus a ball), as one contour.

namespace gouge {

struct OffsetBody {
  const Profile* profile = nullptr;  ///< closed; no elements: leaves the union unchanged
  double growth_mm = 0;              ///< >= 0
};

/// Returns the outer contour of the union: every profile that verify_profile accepts, undercut or hollow too. Its
/// elements carry the body they come from. Where bodies coincide, the earlier of the list names the piece. A pocket
/// that growth closes off from the outside is solid: nothing comes there without passing the tool.
///
/// Requires  The result of verify_profile is empty for each profile, or it has no elements. No gap between the bodies
///           along the axis.
/// Ensures   (1) The result of verify_profile is empty, unless there are no elements. (2) Without growth the corners
///           are the given ones, bit for bit. (3) Neighbouring pieces of one line or circle and body are one element.
///           (4) The contour lies within 1e-9 of the tool's size of the true union.
/// Errors    Code tool-not-closed: the bodies do not make one contour from the tip to the top of the axis.
/// Cost      Quadratic in the number of elements, times an examination of all elements for each piece.
/// Source    Own, docs/method/tool_voronoi.md
[[nodiscard]] Result<Profile> unite(const std::vector<OffsetBody>& bodies);

}  // namespace gouge
