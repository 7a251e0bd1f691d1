#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

namespace gouge {

/// Code of the note on lengths that were taken in mm for a path in inches, which stands beside the verdict.
inline constexpr const char* kLengthsInMm = "option-unit";

/// Names the options that settle reasons for which moves are not checked, the one of most moves first, a sentence each.
/// For example: "--cutcom centre settles the reason of all 46 moves that are not checked: it states that ...". Moves
/// left out on request do not count.
[[nodiscard]] std::vector<std::string> remedies(const ReportModel& model);

/// Returns the cures of a finding; null: none were requested, or it is of the cutter.
[[nodiscard]] const FindingCures* cures_of(const ReportModel& model, std::size_t event);

/// Returns for people: "a tilt of 6.31 deg; a lift of 2.09 mm along the tool axis", or why there is none of either.
[[nodiscard]] std::string cure_text(const ReportModel& model, const FindingCures& cures);

}  // namespace gouge
