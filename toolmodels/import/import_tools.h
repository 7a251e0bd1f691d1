#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/base/units.h"
#include "toolmodels/tool_library.h"

// Tool libraries of other programs, read into ours. Nothing is guessed in silence. Each assumption, contradiction and
// omission stands in `notes`, with the tool's name. The meaning of each format's fields: docs/formats/tool_import.md.

namespace gouge {

enum class ImportFormat { fusion, freecad, nx };

struct ImportOptions {
  std::vector<ToolSegment> holder;    ///< put on tools that have none; empty: they stay without
  std::optional<double> stickout_mm;  ///< tip to holder, for tools whose file does not state
  std::optional<LengthUnit> unit;     ///< for formats that do not state theirs (NX)
  /// Bytes of a file beside the library, for libraries that only name their tools. May be empty.
  std::function<Result<std::string>(const std::string& name)> read_beside;
};

struct ImportedTools {
  ToolLibrary library;  ///< write_tool_library of it reads back as the same tools; may be empty
  /// Errors: a tool that was left out because its numbers make no tool. Warnings: a shape that cannot be imported,
  /// numbers that contradict each other (the message states which were believed). Notes: assumptions.
  Diagnostics notes;
};

/// Imports a Fusion library: JSON, or .tools, which is a zip of it.
/// Errors   The file as a whole cannot be read: json-too-deep, json-too-long, import-syntax, import-duplicate-key,
///          import-format, import-zip. Errors of one tool are in `notes`: import-field, import-shape, import-stickout,
///          import-contradiction, import-number, import-guess, import-left-out, import-empty, and those of
///          make_body_profiles.
[[nodiscard]] Result<ImportedTools> import_fusion(const std::string& file, std::string_view bytes,
                                                  const ImportOptions& options);

/// Imports one FreeCAD tool bit (.fctb), or a library (.fctl) whose bits are read with `read_beside`. Errors as above.
[[nodiscard]] Result<ImportedTools> import_freecad(const std::string& file, std::string_view bytes,
                                                   const ImportOptions& options);

/// Imports an NX tool_database.dat, with the holders of the holder_database.dat beside it, or a holder_database.dat
/// alone. Its unit is the option, or the folder metric or english in the file's name.
/// Errors   As above, and import-unit.
[[nodiscard]] Result<ImportedTools> import_nx(const std::string& file, std::string_view bytes,
                                              const ImportOptions& options);

/// Chooses the importer by the content of the file, not by its name.
[[nodiscard]] std::optional<ImportFormat> recognise_format(std::string_view bytes);

/// Returns the importer of `format`, or of the format that is recognised. Errors: import-format, and those above.
[[nodiscard]] Result<ImportedTools> import_tools(const std::string& file, std::string_view bytes,
                                                 std::optional<ImportFormat> format, const ImportOptions& options);

}  // namespace gouge
