#pragma once

#include <string>
#include <vector>

#include "postproc/report/named_file.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Writes the findings of a report as HTML, the worst first. A script sorts and filters them and keeps many of them
/// quick to scroll. Without it they are pages that fold. The `pictures` are linked from the findings they show. Empty
/// where there are none.
[[nodiscard]] std::string findings_html(const ReportModel& model, const std::vector<NamedFile>& pictures);

/// Moves, findings, deepest and overcut of each operation and of each tool, as HTML. Empty without findings.
[[nodiscard]] std::string summaries_html(const ReportModel& model);

}  // namespace gouge
