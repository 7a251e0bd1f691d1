#pragma once

#include <string>

#include "lib/base/units.h"
#include "lib/path/axis_tilt.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Draws lead and side tilt of a run over the length of its path, before (dashed) and after (solid). It is an inline
/// SVG of the HTML report with the colours of html_style.h. However long the run, at most a few thousand points are
/// drawn: of each pixel the least, the greatest, the first and the last.
/// Empty for a run of no length, or of one beyond all numbers.
[[nodiscard]] std::string axis_chart(const TiltedRun& run, LengthUnit unit);

/// Writes the section "Tool axis" of the HTML report. It has a table of the values before and after, and a chart of
/// each run of tilted axes. Empty where nothing is measured or of interest.
[[nodiscard]] std::string axis_section(const ReportModel& model);

}  // namespace gouge
