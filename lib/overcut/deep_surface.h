#pragma once

#include <vector>

#include "lib/geom/vec.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/motion/motion.h"
#include "lib/tool/convex_cover.h"

namespace gouge {

/// Finds where a surface is deep in a moving tool.
///
/// Requires motion.is_defined(), and the cover of the tool.
/// Ensures  Returns a box for each segment of the motion, along three orthogonal unit vectors, the rows of `frame`. It
///          contains all points of the surface that are more than `depth_mm` deep in the tool at some instant of the
///          segment. It is empty if there are none. A side of a box may be too far out by about `size_mm`, or by more
///          if the budget of pieces is spent.
/// Cost     A microsecond or two for the sweep, and some tens of bounds of pieces.
[[nodiscard]] std::vector<Box3> deep_surface(const Motion& motion, const ConvexCover& cover, const BlockTree& tree,
                                             const Eigen::Matrix3d& frame, double depth_mm, double size_mm);

}  // namespace gouge
