#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "cli/job_options.h"
#include "lib/base/diagnostic.h"
#include "lib/base/result.h"

// Outputs of commands: files, or standard output where their name is "-".

namespace gouge {

/// write_file, or onto `out` where `file` is "-".
[[nodiscard]] Outcome write_output(const std::string& file, std::string_view bytes, std::ostream& out);

/// What will keep these outputs from being written, as far as that can be known before the work is done: their folder
/// is missing or closed to us, or a folder has their name. Empty names and "-" are passed over. Creates and opens
/// nothing. Code: file-unwritable.
[[nodiscard]] Diagnostics find_unwritable(const std::vector<std::string>& files);

/// Of `check` and `correct`, with the folder of the report, which may be missing if it can be made (code
/// folder-unwritable). `corrected` is where the corrected toolpath goes, or empty.
[[nodiscard]] Diagnostics find_unwritable(const JobArguments& arguments, const std::string& corrected);

}  // namespace gouge
