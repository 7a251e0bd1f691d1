#pragma once

#include <cstddef>
#include <vector>

#include "postproc/compare/align_motions.h"
#include "postproc/result/stored_result.h"

namespace gouge {

/// How near two witnesses must be to lie at one place of the part, and with one statement at that.
inline constexpr double kSamePlace_mm = 1, kSameStatement_mm = 10;

/// For each finding of the new run those of the old run that it was, in order. Of one tool, body and counterpart; by the
/// motions that gouge in both, and for findings whose motions are none of the other run's, by statement and place, then by
/// place alone: another motion at the place of a finding that is still checked is a finding of its own.
[[nodiscard]] std::vector<std::vector<std::size_t>> match_findings(const StoredResult& before,
                                                                   const StoredResult& after,
                                                                   const MotionAlignment& motions);

}  // namespace gouge
