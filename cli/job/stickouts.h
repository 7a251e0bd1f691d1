#pragma once

#include <vector>

#include "cli/job/job.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// find_stickouts for the tools of a job, with `result` from its check. `is_extended_up` as in JobArguments.
/// Errors   those of make_non_cutting_variants for a longer tool.
[[nodiscard]] Result<std::vector<StickoutFacts>> find_stickouts_of(const Job& job, const PreparedScene& scene,
                                                                   const CheckResult& result, bool is_extended_up,
                                                                   const StickoutOptions& options,
                                                                   const ProgressCall& progress);

}  // namespace gouge
