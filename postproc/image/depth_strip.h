#pragma once

#include "postproc/image/heat_map.h"

namespace gouge {

/// The depth of every move over its number: what is certain as bars in the colour of the body, what is not
/// excluded as a pale band above, the tolerance as a line; unchecked and buried stretches stand out.
[[nodiscard]] Page draw_depth_strip(const PictureSet& set);

}  // namespace gouge
