#pragma once

#include <string>
#include <vector>

#include "postproc/result/stored_result.h"

namespace gouge {

/// What two runs do not share beside their paths, a sentence each: parts, fixtures, heads, placement, tools of one name,
/// options, the version of the program. Empty: what they found can be compared as it is.
[[nodiscard]] std::vector<std::string> setup_differences(const StoredResult& before, const StoredResult& after);

}  // namespace gouge
