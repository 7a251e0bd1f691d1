#pragma once

#include "lib/verify/named_cut.h"

namespace gouge {

/// The points of a body that are deeper in it than a depth and lie in a block, during a span of time. They lie in a cylinder
/// about the tool axis, which is known without the block's extents across the axis.
struct DeepPart {
  const ToolContour& body;
  double depth_mm = 0;
  const SpaceBlock& block;
  const TimeSpan& span;
};

/// Proves that all these points are in a cutter between two poses, or within `wider_mm` of it, at every instant of the span.
/// Requires RoundsUpward. Cost: linear in the pieces of both contours.
[[nodiscard]] bool is_deep_part_within(const DeepPart& part, const ToolContour& cutter, const CutPoses& poses,
                                       double wider_mm);

}  // namespace gouge
