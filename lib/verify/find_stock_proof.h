#pragma once

#include <cstdint>
#include <string>

#include "lib/verify/cut_search.h"
#include "lib/verify/stock_proof.h"

namespace gouge {

/// Appends the steps of a proof to `steps`. Returns false if it finds no proof within `max_tries`; `steps` is then
/// unchanged. Requires RoundsUpward, at least one piece.
[[nodiscard]] bool find_stock_proof(const StockProofQuestion& question, CutSearch& search, std::uint64_t max_tries,
                                    std::string& steps);

}  // namespace gouge
