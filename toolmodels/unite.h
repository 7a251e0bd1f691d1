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

/// The outer contour of the union: every profile that verify_profile accepts, undercut or hollow too. Its
/// elements carry the body they come from; where bodies coincide, the earlier of the list names the piece. A
/// pocket that growth closes off from the outside is solid (nothing comes there without passing the tool).
///
/// Requires  verify_profile of each profile is empty (or it has no elements); no gap between the bodies along
///           the axis.
/// Ensures   (1) verify_profile is empty (unless there are no elements); (2) without growth the corners are
///           the given ones, bit for bit; (3) neighbouring pieces of one line or circle and body are one
///           element; (4) the contour lies within 1e-9 of the tool's size of the true union.
/// Errors    tool-not-closed: the bodies do not make one contour from the tip to the top of the axis.
/// Cost      Quadratic in the number of elements, times a examine all elements for each piece.
/// Source    Own, docs/method/tool_voronoi.md
[[nodiscard]] Result<Profile> unite(const std::vector<OffsetBody>& bodies);

}  // namespace gouge
