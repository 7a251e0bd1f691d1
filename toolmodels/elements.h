#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"
#include "toolmodels/profile.h"

namespace gouge {

/// Returns the boundary elements of a contour in order: its segments and arcs, and a vertex at every joint where the
/// direction turns. On the axis there is also a vertex if the mirrored contour would turn. Arcs of 150 degrees and more
/// are halved. Support ranges stay empty.
[[nodiscard]] std::vector<BoundaryElement> make_elements(const Profile& profile);

/// Returns the outward unit normal of a segment or arc at one of its points.
[[nodiscard]] Vec2 normal_at(const BoundaryElement& element, const Vec2& point);

/// Computes the support ranges by the contract of SupportRange (lib/tool/compiled_tool.h).
///
/// Requires  Elements that make_elements built from a closed profile.
/// Ensures   A hollow profile gets the ranges that hold with its underside filled, because a solid is never deeper than
///           a larger one. No range covers the hollow. A profile that has several radii at one height even then gets no
///           ranges.
/// Source    Own, docs/method/tool_voronoi.md
void set_support_ranges(const Profile& profile, std::vector<BoundaryElement>& elements);

}  // namespace gouge
