#pragma once

#include "lib/penetration/depth_body.h"

namespace gouge {

/// Fills body.boxes and body.blocks from its tree and corners.
/// Cost  O(n log n).
void fill_node_bounds(DepthBody& body);

}  // namespace gouge
