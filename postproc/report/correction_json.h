#pragma once

#include <nlohmann/json.hpp>

#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the changes, remains and written statements of a correction, and how the tool axis turns before and after;
/// null for a check.
[[nodiscard]] nlohmann::ordered_json correction_json(const ReportModel& model);

}  // namespace gouge
