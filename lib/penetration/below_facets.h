#pragma once

#include <cstdint>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/penetration/depth_body.h"

namespace gouge {

/// The rim of a facet that does not count as its face: points whose foot has a smaller barycentric coordinate
/// are looked at as points of its edges.
inline constexpr double kFaceRim = Tolerance::kRounding;

/// By slot in the tree: 1 when no other facet crosses the prism of the body's depth below the facet. A point
/// in such a prism is inside, and no wall behind the facet is thinner than the depth. Doubt counts as
/// crossing.
/// Cost     a search of the tree for each facet.
[[nodiscard]] std::vector<std::uint8_t> facets_clear_below(const DepthBody& body);

}  // namespace gouge
