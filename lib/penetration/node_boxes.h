#pragma once

#include "lib/penetration/depth_body.h"

namespace gouge {

/// Fills body.boxes from its tree and corners.
/// Cost  O(n).
void fill_node_boxes(DepthBody& body);

}  // namespace gouge
