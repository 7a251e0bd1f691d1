#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

// Wording of accepted findings, for people.

namespace gouge {

/// Returns "1 accepted gouge", "3 accepted gouges".
[[nodiscard]] std::string accepted_words(const ReportModel& model);

/// Remarks on one of CheckResult::events: who accepted it and why, or why it is not accepted although
/// something at it was. None where no acceptance is of it.
[[nodiscard]] std::vector<std::string> acceptance_remarks(const ReportModel& model, std::size_t event);

/// Returns "2 applied, 1 no longer needed, 0 void"; empty without --baseline.
[[nodiscard]] std::string baseline_counts(const ReportModel& model);

/// Returns the lines of the summary: how many acceptances apply, and each that is void with what changed. Empty without
/// --baseline.
[[nodiscard]] std::string baseline_lines(const ReportModel& model);

}  // namespace gouge
