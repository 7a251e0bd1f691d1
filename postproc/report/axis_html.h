#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// The section "Tool axis" of the HTML report: a table of what is measured before and after, and a chart of each run of
/// tilted axes. Empty where nothing is measured or of interest.
[[nodiscard]] std::string axis_section(const ReportModel& model);

}  // namespace gouge
