#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

// Texts about accepted findings.

namespace gouge {

/// Returns "1 accepted gouge" or "3 accepted gouges".
[[nodiscard]] std::string accepted_words(const ReportModel& model);

/// Returns remarks on one of CheckResult::events: who accepted it and why. Or they state why it is not accepted
/// although some of its motions were. None if no acceptance concerns it.
[[nodiscard]] std::vector<std::string> acceptance_remarks(const ReportModel& model, std::size_t event);

/// Returns "2 applied, 1 no longer needed, 0 void"; empty without --baseline.
[[nodiscard]] std::string baseline_counts(const ReportModel& model);

/// Returns the lines of the summary: the number of acceptances that apply, and each void one with the change that voids
/// it. Empty without --baseline.
[[nodiscard]] std::string baseline_lines(const ReportModel& model);

}  // namespace gouge
