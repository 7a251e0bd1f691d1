#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "lib/base/units.h"
#include "toolmodels/assembly.h"

// The project's own tool library file: JSON, one unit for the file, segments from the tip side up.
// Format: docs/formats/tool_library.md.

namespace gouge {

/// A holder by itself, to be put on tools that have none.
struct NamedHolder {
  std::string name;
  std::vector<ToolSegment> segments;
};

/// Returns the number in "3" or "T3", as people write tools; nothing for anything else.
[[nodiscard]] std::optional<int> tool_number(std::string_view text);

struct ToolLibrary {
  std::string file;  ///< as the user named it
  LengthUnit unit = LengthUnit::mm;
  std::vector<ToolAssembly> tools;  ///< mm
  std::vector<NamedHolder> holders;
  Diagnostics notes;                ///< warnings: keys that are not known, and the like
  std::vector<int> shared_numbers;  ///< shared by several tools of an imported file; the first keeps it

  /// Returns the tool of that number; null when there is none.
  [[nodiscard]] const ToolAssembly* with_number(int number) const;
  [[nodiscard]] const ToolAssembly* with_name(std::string_view name) const;
  /// Returns the tool that people mean by `name`: the one of that name, else of that number, written 3 or T3.
  [[nodiscard]] const ToolAssembly* called(std::string_view name) const;
  /// Segments of the holder called `name`, or of the holder of the tool called so; null when there is
  /// neither.
  [[nodiscard]] const std::vector<ToolSegment>* holder_called(std::string_view name) const;
  /// Describes the result of holder_called: "ER16, ball D10", or "none".
  [[nodiscard]] std::string holder_names() const;
};

/// Reads a tool library. Every tool is built once to see that it can be. One that cannot is an error that names tool
/// and field.
///
/// Errors   With file and line: json-too-deep, json-too-long, library-syntax, library-field, library-duplicate-key,
///          library-duplicate-number, library-empty. Also those of make_body_profiles. With library-field a field is
///          missing, of the wrong kind, or an unknown shape, unit or holder.
/// Warnings in `notes`: library-unknown-key, library-duplicate-name, cutter-contradiction.
[[nodiscard]] Result<ToolLibrary> read_tool_library(const std::string& file, std::string_view bytes);

/// Returns the library as a file, in its unit, that reads back as the same library. Ends with a line break.
[[nodiscard]] std::string write_tool_library(const ToolLibrary& library);

}  // namespace gouge
