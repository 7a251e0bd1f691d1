#pragma once

#include <string>
#include <vector>

#include "postproc/accept/accepted.h"
#include "postproc/accept/checked_findings.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Applies acceptances to the findings of a check. A finding is accepted only if each of its moves is. A move needs an
/// acceptance of exactly the same motion, with the same tool, body, counterpart and set-up. It must be proved to be no
/// deeper than accepted, and occur no more often. A move that was not checked or certified, and a buried tool, are
/// never accepted. The proof that this hides no gouge: docs/formats/accepted.md. The result has one event for each
/// finding, and neither a file nor the texts of the entries.
[[nodiscard]] BaselineFacts apply_acceptances(const std::vector<Acceptance>& accepted, const CheckedFindings& checked);

/// Does the same for a report that names `file`.
[[nodiscard]] BaselineFacts apply_baseline(const std::string& file, const std::vector<Acceptance>& accepted,
                                           const ReportModel& model);

}  // namespace gouge
