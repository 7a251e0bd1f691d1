#pragma once

#include <cstddef>
#include <vector>

#include "postproc/compare/compare_results.h"
#include "postproc/compare/match_findings.h"

namespace gouge {

/// Judges finding `n` of the new run beside the matching findings `was` of the old run: new, deeper, shallower or the
/// same, with the reason. The depths are those of the body and the obstacle of the finding.
[[nodiscard]] ComparedFinding judge_finding(const StoredResult& before, const StoredResult& after,
                                            const MotionAlignment& motions, const CompareOptions& options,
                                            std::size_t n, const std::vector<std::size_t>& was);

}  // namespace gouge
