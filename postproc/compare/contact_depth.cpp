#include "postproc/compare/contact_depth.h"

#include <algorithm>

namespace gouge {

std::optional<DepthBounds> contact_depth(const MoveRecord& move, Body body, Against against) {
  if (move.state == MoveState::buried) return DepthBounds{kAnyDepth_mm, kAnyDepth_mm};
  if (move.witness && move.witness->body == body && move.witness->against == against)
    return DepthBounds{move.depth_mm.value_or(0), move.depth_upper_mm.value_or(kAnyDepth_mm)};
  const auto further = std::ranges::find_if(
      move.further, [&](const FurtherRecord& one) { return one.body == body && one.against == against; });
  if (further == move.further.end()) return std::nullopt;
  return DepthBounds{further->depth_mm.value_or(0), further->depth_upper_mm.value_or(kAnyDepth_mm)};
}

}  // namespace gouge
