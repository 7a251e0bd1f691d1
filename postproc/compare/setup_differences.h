#pragma once

#include <string>
#include <vector>

#include "postproc/result/stored_result.h"

namespace gouge {

/// Returns the differences of the set-ups of two runs, a sentence each. Compared are files, placement, tools with the same
/// key, all recorded options, the moves, and the version of the program. Empty: their findings are directly comparable.
[[nodiscard]] std::vector<std::string> setup_differences(const StoredResult& before, const StoredResult& after);

}  // namespace gouge
