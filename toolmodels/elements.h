#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"
#include "toolmodels/profile.h"

namespace gouge {

/// The boundary elements of a contour in order: its segments and arcs, and a vertex at every joint where the
/// direction turns, on the axis also where the mirrored contour would. Arcs of 150 degrees and more are
/// halved. Support ranges are left empty.
[[nodiscard]] std::vector<BoundaryElement> make_elements(const Profile& profile);

/// The outward normal of a segment or arc at a point of it; unit.
[[nodiscard]] Vec2 normal_at(const BoundaryElement& element, const Vec2& point);

/// Fills in the support ranges by the contract of SupportRange (lib/tool/compiled_tool.h).
///
/// Requires  Elements as make_elements gives them, of a closed profile.
/// Ensures   A hollow profile claims what it would with its underside filled (a solid is never deeper than a
///           larger one), and nothing within the hollow; one that is not single-valued even then, nothing.
/// Source    Own, docs/method/tool_voronoi.md
void set_support_ranges(const Profile& profile, std::vector<BoundaryElement>& elements);

}  // namespace gouge
