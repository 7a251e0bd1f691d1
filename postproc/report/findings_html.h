#pragma once

#include <string>
#include <vector>

#include "postproc/report/named_file.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the findings of a report as HTML, the worst first. A script sorts and filters them, and keeps scrolling fast
/// if there are many. Without a script they are pages that fold. `pictures` are linked from their findings. Empty if
/// there are no findings. `review` is HtmlParts::review.
[[nodiscard]] std::string findings_html(const ReportModel& model, const std::vector<NamedFile>& pictures,
                                        const std::string& review);

/// Returns the largest overcut of the moves of a finding in mm, as in the key of the heat map; 0 if none is measured.
[[nodiscard]] double overcut_of(const ReportModel& model, const Event& event);

}  // namespace gouge
