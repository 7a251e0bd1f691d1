#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Measures the stock that a corrected path leaves on surfaces that were finished before. Reports the maximum of each
/// stretch of neighbouring changed moves, if it exceeds the tolerance by more than a limit. The limit is the smaller of
/// the default and the permitted TiltOptions::max_stock_mm. Left-out stretches (Correction::uncut) are not measured,
/// and rapids cut nothing.
///
/// Requires `after` to be `path` with the changes.
/// Ensures  The result is the same at any number of threads, and in path order.
/// Cost     Bounded: some tenths of a second for all stretches together, and a share for each move. Results that are
///          not decided by then are marked.
[[nodiscard]] std::vector<StockStretch> measure_stock(const Toolpath& path, const Correction& correction,
                                                      const Toolpath& after, const CheckSetup& setup,
                                                      const CorrectOptions& correct);

}  // namespace gouge
