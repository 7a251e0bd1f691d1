#pragma once

#include <vector>

#include "lib/base/result.h"
#include "toolmodels/profile.h"

// The union of bodies, each offset by its own clearance (the solid of revolution plus a ball), as one contour.

namespace gouge {

struct OffsetBody {
  const Profile* profile = nullptr;  ///< closed; one without elements leaves the union unchanged
  double growth_mm = 0;              ///< >= 0
};

/// Returns the outer contour of the union, for every profile that verify_profile accepts, undercut or hollow too. Each
/// element states the body that it comes from; where bodies coincide, the earlier one in the list. A pocket that growth
/// closes off from the outside is solid, because no point gets there without passing through the tool.
///
/// Requires  The result of verify_profile is empty for each profile, or it has no elements. No gap between the bodies
///           along the axis.
/// Ensures   (1) The result of verify_profile is empty, unless there are no elements. (2) Without growth the corners
///           are the given ones, bit for bit. (3) Neighbouring pieces of one line or circle that belong to one body are
///           one element. (4) The contour lies within 1e-9 of the tool's size of the true union.
/// Errors    Code tool-not-closed: the bodies do not make one contour from the tip to the top of the axis.
/// Cost      Quadratic in the number of elements, times an examination of all elements for each piece.
/// Source    Own, docs/method/tool_voronoi.md
[[nodiscard]] Result<Profile> unite(const std::vector<OffsetBody>& bodies);

}  // namespace gouge
