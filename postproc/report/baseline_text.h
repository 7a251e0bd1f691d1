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

/// Returns the lines of the summary: the number of acceptances that apply, each void one with the change that voids it,
/// and each one that accepts only a part of a finding. Empty without --baseline.
[[nodiscard]] std::string baseline_lines(const ReportModel& model);

/// Returns whether a file of an acceptance may be the checked one: their names are equal, or one ends with the other.
[[nodiscard]] bool is_same_program(const std::string& accepted, const std::string& checked);

/// Returns whether an acceptance was made for another program than the checked one; false if it names none.
[[nodiscard]] bool is_of_other_program(const std::string& accepted, const std::string& checked);

/// Returns the number of accepted findings whose acceptance was made for another program.
[[nodiscard]] std::size_t accepted_through_others(const ReportModel& model);

/// Begins the words about the entry of another program, in acceptance_remarks.
inline constexpr const char* kThroughEntry = " through the entry of ";

}  // namespace gouge
