#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// The cures of a finding; null: none were asked for, or it is of the cutter.
[[nodiscard]] const FindingCures* cures_of(const ReportModel& model, std::size_t event);

/// For people: "a tilt of 6.31 deg; a lift of 2.09 mm along the tool axis", or why there is none of either.
[[nodiscard]] std::string cure_text(const ReportModel& model, const FindingCures& cures);

}  // namespace gouge
