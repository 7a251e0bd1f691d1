#pragma once

#include "postproc/image/heat_map.h"

namespace gouge {

/// One finding close up: the part with the tool at the worst instant, and the section through the tool's axis
/// and the deepest point, whole and enlarged with the depth as an arrow.
[[nodiscard]] Page draw_event(const PictureSet& set, const PictureEvent& event);

}  // namespace gouge
