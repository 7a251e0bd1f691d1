#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"

namespace gouge {

/// A command line with the command that the user left out.
struct ShortLine {
  std::vector<std::string> words;   ///< of `check`; with an error, they still name all files and outputs
  std::optional<Diagnostic> error;  ///< why there is nothing to check
};

/// Returns the words of a command line with the command that they leave out: `gougecheck PATH PART [TOOLS] [OPTIONS]` is
/// `gougecheck check PATH --part PART --tools TOOLS --report PATH_report [OPTIONS]`. The files are in any order, and their
/// contents state which is which. A file whose content states nothing takes the place that is missing, so that its
/// reader names the fault. The report stands beside the toolpath, unless --report is given. `words` begins with the
/// program's name, and stays unchanged if `commands` has its second word.
///
/// Errors   Those of InputReader; file-is-folder; path-not-cl-data; file-unrecognised (a file that has no place);
///          usage (none or several of the files are a toolpath, several are STL files or tool libraries).
[[nodiscard]] ShortLine expand_short_line(const std::vector<std::string>& words,
                                          const std::vector<std::string>& commands);

}  // namespace gouge
