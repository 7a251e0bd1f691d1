#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/terminal/progress.h"
#include "lib/base/file_search.h"
#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/report/report_model.h"
#include "toolmodels/tool_library.h"

namespace gouge {

/// Reads a toolpath and adds its file to `inputs` with that role, and its searches for files beside it to `searches`.
/// Nothing: `errors` has the reasons.
/// Errors: those of read_long_file, also for a program beside the file, and read_toolpath. path-too-far: a position beyond
/// the reach of the check.
[[nodiscard]] std::optional<Toolpath> read_path_file(const std::string& file, const char* role, std::uint64_t max_bytes,
                                                     const ReadOptions& reading, Progress& progress,
                                                     std::vector<InputFile>& inputs, SearchLog& searches,
                                                     Diagnostics& errors);

/// Reads a tool library of any form, and adds its file and the files that it names to `inputs`, and the searches for
/// those to `searches`.
/// Errors: those of read_file and read_any_tools.
[[nodiscard]] Result<ToolLibrary> read_tool_file(const std::string& file, const char* role, std::uint64_t max_bytes,
                                                 std::vector<InputFile>& inputs, SearchLog& searches);

}  // namespace gouge
