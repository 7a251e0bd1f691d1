#pragma once

#include <string>
#include <vector>

#include "postproc/accept/accepted.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Applies the acceptances of `file` to a result. A finding is accepted only where each of its moves is. The motion
/// must be the very same, with the same tool, body, counterpart and set-up. It must be proved no deeper than it was,
/// and occur no more often. A move that was not checked or certified, and a buried tool, is never accepted. The proof
/// that this hides no gouge: docs/formats/accepted.md.
[[nodiscard]] BaselineFacts apply_baseline(const std::string& file, const std::vector<Acceptance>& accepted,
                                           const ReportModel& model);

}  // namespace gouge
