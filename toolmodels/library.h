#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/base/units.h"
#include "toolmodels/assembly.h"

// Tool libraries: docs/formats/tool_library.md.

namespace gouge {

struct NamedHolder {
  std::string name;
  std::vector<ToolSegment> segments;
};

struct ToolLibrary {
  std::string file;                  ///< as the user named it
  LengthUnit unit = LengthUnit::mm;  ///< of the file; everything here is in mm
  std::vector<ToolAssembly> tools;   ///< in the order of the file; numbers are unique
  std::vector<NamedHolder> holders;  ///< holders of their own, for --holder
  Diagnostics notes;                 ///< warnings of reading
};

/// Reads and validates a library: every tool in it makes a closed profile.
///
/// Errors   those of read_file; library-not-json, library-not-understood, library-without-tools,
///          library-duplicate-key, library-duplicate-number, library-missing-field, library-wrong-type,
///          library-unknown-shape, library-unknown-unit, library-unknown-holder, and those of
///          make_body_profiles; with file, line and tool.
/// Warnings library-unknown-key, library-duplicate-name, tool-apt-contradiction.
[[nodiscard]] Result<ToolLibrary> read_library(const std::string& path);

/// The same from a text; `file` is for messages.
[[nodiscard]] Result<ToolLibrary> parse_library(std::string_view text, const std::string& file);

/// The library as text in its unit. Ensures parse_library of it gives the same tools.
[[nodiscard]] std::string library_text(const ToolLibrary& library);

/// Writes library_text, whole or not at all.
[[nodiscard]] Outcome write_library(const ToolLibrary& library, const std::string& path);

/// The tool of that number, or null.
[[nodiscard]] const ToolAssembly* find_tool(const ToolLibrary& library, int number);
/// The first tool of that name (letter by letter), or null.
[[nodiscard]] const ToolAssembly* find_tool(const ToolLibrary& library, std::string_view name);

/// The holder of that name, or the holder of the tool of that name or number ("T3", "3").
/// Errors   library-unknown-holder, naming what there is.
[[nodiscard]] Result<std::vector<ToolSegment>> find_holder(const ToolLibrary& library, std::string_view name);

}  // namespace gouge
