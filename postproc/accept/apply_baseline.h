#pragma once

#include <string>
#include <vector>

#include "postproc/accept/accepted.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Applies the acceptances of `file` to a result. A finding is accepted only if each of its moves is. A move needs an
/// acceptance of exactly the same motion, with the same tool, body, counterpart and set-up. It must be proved to be no
/// deeper than accepted, and occur no more often. A move that was not checked or certified, and a buried tool, are
/// never accepted. The proof that this hides no gouge: docs/formats/accepted.md.
[[nodiscard]] BaselineFacts apply_baseline(const std::string& file, const std::vector<Acceptance>& accepted,
                                           const ReportModel& model);

}  // namespace gouge
