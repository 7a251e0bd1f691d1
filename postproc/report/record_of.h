#pragma once

#include <optional>

#include "postproc/record/result_record.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the content of a result file. Cost: linear in the moves. Statements are copied, but the path is not.
[[nodiscard]] ResultRecord record_of(const ReportModel& model);

/// Returns the section "correction"; none for a check.
[[nodiscard]] std::optional<CorrectionRecord> correction_record_of(const ReportModel& model);

}  // namespace gouge
