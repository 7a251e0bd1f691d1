#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// Returns what keeps the verdict from clean, as a list in HTML: findings that are not accepted, the deepest first, and
/// reasons why moves were not checked. Items beyond the first few are counted. Empty if nothing is open.
[[nodiscard]] std::string open_items_html(const ReportModel& model);

}  // namespace gouge
