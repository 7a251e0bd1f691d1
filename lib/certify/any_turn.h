#pragma once

#include <cstddef>
#include <optional>

#include "lib/base/parallel.h"
#include "lib/check/check_result.h"

namespace gouge {

struct CheckSetup;

/// Counts the clean moves that stay clean wherever the rotary joints are between their ends (LawScope::any). The tool of a
/// rapid is examined with all its bodies; that of any other move without the cutter. Heads are examined in both. A proof
/// does not depend on the law of the control. Where there is none, the verdict rests on that law.
///
/// Requires a complete result. Returns nothing if the law of motion has no machine, or if no move turns a rotary joint.
/// Cost     That of check_moves with at most twelve boxes (CheckOptions::turn_boxes) for each move.
[[nodiscard]] std::optional<AnyTurnCounts> count_any_turns(const Toolpath& path, const CheckSetup& setup,
                                                           const CheckResult& result, const ProgressCall& progress);

}  // namespace gouge
