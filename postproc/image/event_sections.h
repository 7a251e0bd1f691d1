#pragma once

#include <string>

#include "postproc/image/heat_map.h"

namespace gouge {

/// The right of a finding's page: the section through the deepest point and the region enlarged, with the
/// depth as an arrow called `words`. What is buried has no deepest point: one section of all of it.
void add_sections(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words);

}  // namespace gouge
