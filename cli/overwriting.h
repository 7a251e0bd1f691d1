#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/job_options.h"
#include "lib/base/diagnostic.h"

namespace gouge {

/// A file of the command line and what names it: "--csv", "the toolpath".
struct FileOption {
  std::string what, file;
};

/// Why nothing may be written: an output is one of the inputs, or another output, under whatever name. Empty names and
/// "-" are passed over.
[[nodiscard]] std::optional<Diagnostic> find_overwriting(const std::vector<FileOption>& inputs,
                                                         const std::vector<FileOption>& outputs);

/// Of `check` and `correct`; `corrected` is where the corrected toolpath goes, or empty.
[[nodiscard]] std::optional<Diagnostic> find_overwriting(const JobArguments& arguments, const std::string& corrected);

}  // namespace gouge
