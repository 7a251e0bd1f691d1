#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

enum class AfterRun {
  go_on,  ///< continue to watch; run again after a change
  again,  ///< nothing was done: run the same again after a pause
  end
};
using RunToolpaths = std::function<AfterRun(const std::vector<std::string>&)>;

/// Calls `run` with the toolpaths of a folder, sorted, at once and after every change of them. Ends when `run` returns
/// AfterRun::end. A file is included as soon as it is settled (SettledFiles), because a CAM system may write it in
/// pieces. The argument `place` is a folder, whose toolpaths have known endings (has_toolpath_ending), or a pattern such
/// as "hot/*.apt". Errors: usage, if there is no such folder.
[[nodiscard]] Outcome watch_toolpaths(const std::string& place, bool are_programs, const RunToolpaths& run);

}  // namespace gouge
