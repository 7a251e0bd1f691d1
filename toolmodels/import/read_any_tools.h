#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/tool_library.h"

namespace gouge {

struct ReadTools {
  ToolLibrary library;              ///< its notes are those of the importer, where one read it
  std::vector<BesideFile> besides;  ///< files that the library names and that were read for it
};

/// Reads a tool library of this project or, by its importer, one of another program. The reports of the importer are in
/// the notes of the library; a tool that it leaves out is a warning there.
///
/// Errors   (1) Those of read_tool_library and import_tools. (2) library-foreign: a file of another kind, which the
///          message names with what to do. (3) library-empty: no tool of the file can be imported, with the first
///          reason.
[[nodiscard]] Result<ReadTools> read_any_tools(const std::string& file, std::string_view bytes,
                                               std::uint64_t max_bytes);

[[nodiscard]] bool is_zip(std::string_view bytes);

/// Returns the first file of the archive whose name ends in `ending`. Errors: import-zip (also for one larger than 256
/// MB, which no library is).
[[nodiscard]] Result<std::string> unzip_first(const std::string& file, std::string_view bytes, std::string_view ending);

}  // namespace gouge
