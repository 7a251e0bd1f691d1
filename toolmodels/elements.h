#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"
#include "toolmodels/profile.h"

namespace gouge {

/// Returns the boundary elements of a contour in order: its segments and arcs, and a vertex at every joint where the
/// direction turns. On the axis there is a vertex also where the mirrored contour would turn. Arcs of 150 degrees and
/// more are halved. Support ranges are left empty.
[[nodiscard]] std::vector<BoundaryElement> make_elements(const Profile& profile);

/// Returns the outward normal of a segment or arc at a point of it; unit.
[[nodiscard]] Vec2 normal_at(const BoundaryElement& element, const Vec2& point);

/// Fills in the support ranges by the contract of SupportRange (lib/tool/compiled_tool.h).
///
/// Requires  Elements as make_elements gives them, of a closed profile.
/// Ensures   A hollow profile claims the same as with its underside filled, as a solid is never deeper than a larger
///           one. It claims nothing within the hollow. A profile that is not single-valued even then claims nothing.
/// Source    Own, docs/method/tool_voronoi.md
void set_support_ranges(const Profile& profile, std::vector<BoundaryElement>& elements);

}  // namespace gouge
