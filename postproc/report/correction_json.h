#pragma once

#include <nlohmann/json.hpp>

#include "postproc/report/report_model.h"

namespace gouge {

/// What a correction changed, left and wrote, and how the tool axis turns before and after; null for a check.
[[nodiscard]] nlohmann::ordered_json correction_json(const ReportModel& model);

}  // namespace gouge
