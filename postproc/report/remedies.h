#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

namespace gouge {

/// Code of the note, next to the verdict, about lengths that were taken in mm for a path in inches.
inline constexpr const char* kLengthsInMm = "option-unit";

/// Code of the note, next to the verdict, about options that have no effect.
inline constexpr const char* kOptionUnused = "option-unused";

/// Returns a note about facts for which the user vouches, and which the check of `path_file` does not have.
[[nodiscard]] Diagnostics describe_unused(const std::vector<Vouched>& vouched, const Assumptions& facts,
                                          const std::string& path_file);

/// Returns the options that settle reasons why moves are not checked, a sentence each; the one for most moves is first.
/// For example: "--cutcom centre settles the reason of all 46 moves that are not checked: it states that ...". Moves
/// that were excluded on request do not count.
[[nodiscard]] std::vector<std::string> remedies(const ReportModel& model);

/// Returns the cures of a finding; null: none were requested, or the cutter gouges.
[[nodiscard]] const FindingCures* cures_of(const ReportModel& model, std::size_t event);

/// Returns the cures as text: "a tilt of 6.31 deg; a lift of 2.09 mm along the tool axis". Or the text states why there
/// is none.
[[nodiscard]] std::string cure_text(const ReportModel& model, const FindingCures& cures);

}  // namespace gouge
