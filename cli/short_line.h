#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

/// Returns the words of a command line with the command that they leave out: `gougecheck PATH PART [TOOLS] [OPTIONS]` is
/// `gougecheck check PATH --part PART --tools TOOLS --report PATH_report [OPTIONS]`. The files are in any order, and their
/// contents state which is which. The report stands beside the toolpath, unless --report is given. `words` begins with
/// the program's name, and stays unchanged if `commands` has its second word.
///
/// Errors   Those of InputReader; file-is-folder; usage (none or several of the files are a toolpath, several are STL
///          files or tool libraries).
[[nodiscard]] Result<std::vector<std::string>> expand_short_line(const std::vector<std::string>& words,
                                                                 const std::vector<std::string>& commands);

}  // namespace gouge
