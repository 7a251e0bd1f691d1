#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Measures the stock that a corrected path leaves on surfaces finished before. It reports the maximum of each stretch
/// of neighbouring changed moves where that exceeds the tolerance by more than a limit. The limit is the lesser of the
/// usual and the allowed TiltOptions::max_stock_mm. Left-out stretches (Correction::uncut) are not measured, and rapids
/// cut nothing.
///
/// Requires `after` to be `path` with the changes.
/// Ensures  The same at any number of threads; in path order.
/// Cost     Bounded: some tenths of a second for all stretches together, and a share for each move. Results that are
///          not decided by then are marked.
[[nodiscard]] std::vector<StockStretch> measure_stock(const Toolpath& path, const Correction& correction,
                                                      const Toolpath& after, const CheckSetup& setup,
                                                      const CorrectOptions& correct);

}  // namespace gouge
