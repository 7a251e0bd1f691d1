#pragma once

#include <string>

#include "lib/base/units.h"
#include "lib/path/axis_tilt.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Draws lead and side tilt of a run over the length of its path, before (dashed) and after (solid). The result is an
/// inline SVG for the HTML report, with the colours of html_style.h. At most a few thousand points are drawn for a run
/// of any length. They are the minimum, the maximum, the first and the last of each pixel.
/// The result is empty for a run of length 0 or of a length that is not finite.
[[nodiscard]] std::string axis_chart(const TiltedRun& run, LengthUnit unit);

/// Returns the section "Tool axis" of the HTML report. It has a table of the values before and after, and a chart of
/// each run of tilted axes. Empty if nothing was measured or is of interest.
[[nodiscard]] std::string axis_section(const ReportModel& model);

}  // namespace gouge
