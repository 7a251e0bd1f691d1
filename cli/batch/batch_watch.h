#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

enum class AfterRun {
  go_on,  ///< and run again once something has changed
  again,  ///< nothing was done: run the same again, after a pause
  end
};
using RunToolpaths = std::function<AfterRun(const std::vector<std::string>&)>;

/// Calls `run` with the toolpaths of a folder, sorted, at once and whenever they have changed. Ends when `run` returns
/// that this is the end. A file counts once it is settled (SettledFiles), as a CAM system may write it in pieces. The
/// argument `place` is a folder, or a pattern such as "hot/*.apt". Errors: usage, where there is no such folder.
[[nodiscard]] Outcome watch_toolpaths(const std::string& place, const RunToolpaths& run);

}  // namespace gouge
