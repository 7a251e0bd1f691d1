#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

/// Calls `run` with the toolpaths of a folder, sorted, now and whenever they have changed, until it returns false. A file
/// counts once it is settled: neither its size nor its time has changed for a second, as a CAM system may write it in
/// pieces. `place`: a folder, of which hidden and temporary files are passed over, or a pattern such as "hot/*.apt".
/// Errors: usage, where there is no such folder.
[[nodiscard]] Outcome watch_toolpaths(const std::string& place,
                                      const std::function<bool(const std::vector<std::string>&)>& run);

}  // namespace gouge
