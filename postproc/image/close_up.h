#pragma once

#include <string>

#include "postproc/image/heat_map.h"

namespace gouge {

/// The left of a finding's page: part, tool and heads at its worst instant, `words` pointing at the point,
/// with triad, scale and colours.
void add_close_up(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words);

}  // namespace gouge
