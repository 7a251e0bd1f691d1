#pragma once

#include <string>

#include "postproc/report/report_model.h"

namespace gouge {

/// The findings as SARIF 2.1.0, for code hosts and editors: one result an event, and one for each reason why
/// moves were not checked or not certified. Rules: gouge, buried, near, not-checked, not-certified.
/// The fingerprint of a finding holds as long as its statement, tool and body do, wherever the line moves.
[[nodiscard]] std::string write_sarif(const ReportModel& model);

}  // namespace gouge
