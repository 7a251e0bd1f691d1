#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/file_search.h"
#include "lib/base/result.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/tool_library.h"

namespace gouge {

struct ReadTools {
  ToolLibrary library;              ///< if an importer read it, its notes are those of the importer
  std::vector<BesideFile> besides;  ///< files that the library names, as read for it
};

/// Reads a tool library of this project, or imports one of another program. The reports of the importer are in the
/// notes of the library; a tool that the importer leaves out is a warning there. `facts` holds for imports; files beside
/// the library are read in any case, and each search for one is added to `searches`.
///
/// Errors   (1) Those of read_tool_library and import_tools. (2) library-foreign: a file of another kind, which the
///          message names, with advice. (3) library-empty: no tool of the file can be imported; the message has the
///          first reason.
[[nodiscard]] Result<ReadTools> read_any_tools(const std::string& file, std::string_view bytes, std::uint64_t max_bytes,
                                               SearchLog& searches, const ImportOptions& facts = {});

/// Reads a file as read_any_tools does its bytes, for a use that no result depends on. Errors: those of read_file besides.
[[nodiscard]] Result<ReadTools> read_tools_file(const std::string& file, std::uint64_t max_bytes);

/// Returns what a file is that is no tool library, and what was expected, with advice.
[[nodiscard]] std::string describe_foreign_library(const std::string& file, std::string_view bytes);

[[nodiscard]] bool is_zip(std::string_view bytes);

/// Returns the first file of the archive whose name ends in `ending`. Errors: import-zip, also for a file larger than
/// 256 MB, which no library reaches.
[[nodiscard]] Result<std::string> unzip_first(const std::string& file, std::string_view bytes, std::string_view ending);

}  // namespace gouge
