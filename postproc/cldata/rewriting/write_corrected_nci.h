#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// write_corrected for a Mastercam NCI file. Requires changes that write_corrected has checked.
/// Ensures  What write_corrected.h guarantees. An inserted position whose axis is not +Z, before a pair that
///          cannot say an axis, looks like the last five-axis line before it, or else the first one of the
///          file.
/// Errors   write-arc (an arc that stays begins at a position that moves), write-axis (an axis other than +Z for a pair
///          that has none, or for an inserted position in a file without five-axis lines).
[[nodiscard]] Result<std::string> write_corrected_nci(const Toolpath& path, const std::vector<PathChange>& changes);

}  // namespace gouge
