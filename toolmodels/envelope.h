#pragma once

#include <vector>

#include "toolmodels/profile.h"

// The union of bodies, each grown by its own clearance, as one contour. A body {r <= rho(z)} grown by a ball
// of radius c is again of that form, so the union is the upper envelope over z of lines and circular arcs:
// every segment and arc moved out by c, and a disc of radius c about every corner.

namespace gouge {

struct GrownBody {
  const Profile* profile = nullptr;  ///< closed, single-valued; no elements: leaves the union unchanged
  double growth_mm = 0;              ///< >= 0
};

/// Contour of the union, horizontal steps where the radius jumps. Its elements carry the body they come from;
/// a step belongs to the wider side. Where bodies coincide the one nearer to the tip names the piece.
///
/// Requires  single-valued profiles whose z ranges, grown, leave no gap between them.
/// Ensures   (1) verify_profile is empty (unless every profile is); (2) without growth the corners are
///           the given ones, bit for bit; (3) neighbouring pieces of one line or circle and body are one
///           element; (4) elsewhere the contour lies within 1e-10 of the tool's size of the true union.
/// Cost      cubic in the number of elements.
/// Source    own, docs/algorithms/tool_voronoi.md
[[nodiscard]] Profile unite(const std::vector<GrownBody>& bodies);

}  // namespace gouge
