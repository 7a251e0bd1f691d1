#pragma once

#include <string>
#include <vector>

#include "postproc/report/named_file.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the findings of a report as HTML, the worst first. A script sorts and filters them, and keeps scrolling fast
/// if there are many. Without a script they are pages that fold. `pictures` are linked from their findings. Empty if
/// there are no findings.
[[nodiscard]] std::string findings_html(const ReportModel& model, const std::vector<NamedFile>& pictures);

/// Returns moves, findings, depth and overcut for each operation and each tool, as HTML. Empty without findings.
[[nodiscard]] std::string summaries_html(const ReportModel& model);

}  // namespace gouge
