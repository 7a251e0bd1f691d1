#pragma once

#include <string>

#include "lib/base/units.h"
#include "lib/path/axis_tilt.h"

namespace gouge {

/// Lead and side tilt of a run over the length of its path, before (dashed) and after (solid), as an inline SVG of the
/// HTML report. Colours are those of html_style.h. However long the run, at most a few thousand points are drawn: of
/// each pixel the least, the greatest, the first and the last.
/// Empty for a run of no length, or of one beyond all numbers.
[[nodiscard]] std::string axis_chart(const TiltedRun& run, LengthUnit unit);

}  // namespace gouge
