#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"

namespace gouge {

enum class AfterRun {
  go_on,  ///< continue to watch; run again after a change
  again,  ///< nothing was done: run the same again after a pause
  end
};
using RunToolpaths = std::function<AfterRun(const std::vector<std::string>&)>;
using TakeWarning = std::function<void(const Diagnostic&)>;

struct WatchedPlace {
  std::string place;          ///< a folder, or a pattern such as "hot/*.apt"
  std::string output;         ///< folder of the results, whose files are no toolpaths
  bool are_programs = false;  ///< which endings the toolpaths of a folder have (has_toolpath_ending)
  /// Returns the files other than toolpaths that the next run reads, as far as they are known.
  std::function<std::vector<std::string>()> inputs;
};

/// Returns why a place cannot be watched: there is no such folder (code usage). Returns nothing if it can.
[[nodiscard]] std::optional<Diagnostic> find_wrong_place(const std::string& place);

/// Calls `run` with the toolpaths of a folder and the folders below it, sorted, at once and after every change of them or
/// of the inputs. Ends when `run` returns AfterRun::end. A file is included as soon as it is settled (SettledFiles),
/// because a CAM system may write it in pieces. Calls `warn` once for each folder below that cannot be read.
void watch_toolpaths(const WatchedPlace& watched, const RunToolpaths& run, const TakeWarning& warn);

}  // namespace gouge
