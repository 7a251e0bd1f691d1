#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "lib/base/units.h"
#include "toolmodels/assembly.h"

// The tool library file of this project: JSON, with one unit for the file, and segments listed from the tip side up.
// Format: docs/formats/tool_library.md.

namespace gouge {

/// A holder without a tool, for tools that have none.
struct NamedHolder {
  std::string name;
  std::vector<ToolSegment> segments;
  /// States why the holder may be another one than described; empty: it is certain.
  std::string uncertainty{};
};

/// Returns the uncertainty of a tool that has this holder; empty if the holder is certain.
[[nodiscard]] std::string uncertainty_of_owner(const NamedHolder& holder);

/// Returns the number in "3" or "T3", the forms in which users write tools; nothing for any other text.
[[nodiscard]] std::optional<int> tool_number(std::string_view text);

struct ToolLibrary {
  std::string file;  ///< path as the user gave it
  LengthUnit unit = LengthUnit::mm;
  std::vector<ToolAssembly> tools;  ///< lengths in mm
  std::vector<NamedHolder> holders;
  Diagnostics notes;  ///< warnings, such as unknown keys
  /// Numbers and names that several tools of the file share, including tools of an imported file that were left out. The
  /// first tool of the library keeps the number.
  std::vector<int> shared_numbers;
  std::vector<std::string> shared_names;

  /// Returns the tool with that number; null if there is none.
  [[nodiscard]] const ToolAssembly* with_number(int number) const;
  [[nodiscard]] const ToolAssembly* with_name(std::string_view name) const;
  [[nodiscard]] bool is_shared_number(int number) const;
  [[nodiscard]] bool is_shared_name(std::string_view name) const;
  /// Returns the tool that a user means by `name`: the one with that name, else with that number, written 3 or T3.
  [[nodiscard]] const ToolAssembly* called(std::string_view name) const;
  /// Returns the two tools of which `name` is the name of one and the number of the other, and how to choose between them.
  /// Empty: it means one tool at most.
  [[nodiscard]] std::string two_tools_called(std::string_view name) const;
  /// Returns the holder with this name, or that of the tool with this name, which is as uncertain as the tool. Returns
  /// nothing if there is neither.
  [[nodiscard]] std::optional<NamedHolder> holder_called(std::string_view name) const;
  /// Returns the names that holder_called accepts: "ER16, ball D10", or "none".
  [[nodiscard]] std::string holder_names() const;
};

/// Reads a tool library. Every tool is built once as a test. If that fails, the error names the tool and the field.
///
/// Errors   With file and line: json-too-deep, json-too-long, library-syntax, library-field, library-duplicate-key,
///          library-duplicate-number, library-empty. Also those of make_body_profiles. The code library-field means
///          that a field is missing or of the wrong kind, or names an unknown shape, unit or holder.
/// Warnings in `notes`: library-unknown-key, library-duplicate-name, cutter-contradiction.
[[nodiscard]] Result<ToolLibrary> read_tool_library(const std::string& file, std::string_view bytes);

/// Returns the text of a library file, in the unit of the library, that reads back as the same library. It ends with a
/// line break.
[[nodiscard]] std::string write_tool_library(const ToolLibrary& library);

}  // namespace gouge
