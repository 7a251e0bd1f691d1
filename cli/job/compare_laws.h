#pragma once

#include <vector>

#include "cli/job/job.h"

namespace gouge {

/// Checks the path of a job by each law of motion that its machine can run, for feeds and for rapids apart. A law that
/// needs a fact that is not given has the reason in LawRecord::missing. Requires Job::machine.
/// Cost     That of a check for each law.
[[nodiscard]] std::vector<LawRecord> compare_laws(const Job& job, const PreparedScene& scene,
                                                  const ProgressCall& progress);

}  // namespace gouge
