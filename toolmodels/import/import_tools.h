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

// Reads tool libraries of other programs into ours. Every assumption, contradiction and omission is in `notes`, with
// the name of the tool. The meaning of the fields of each format: docs/formats/tool_import.md.

namespace gouge {

enum class ImportFormat { fusion, freecad, nx, camotics, linuxcnc };

struct ImportOptions {
  std::vector<ToolSegment> holder;    ///< holder of tools that have none; empty: they stay without a holder
  std::string holder_uncertainty;     ///< see NamedHolder::uncertainty
  std::optional<double> stickout_mm;  ///< tip to holder, for tools whose file does not state this length
  std::optional<LengthUnit> unit;     ///< unit of files whose format does not state one (NX)
  /// Reads the bytes of a file beside the library, for libraries that only name the files of their tools. May be empty.
  std::function<Result<std::string>(const std::string& name)> read_beside;
};

struct ImportedTools {
  ToolLibrary library;  ///< reads back as the same tools after write_tool_library; may be empty
  /// Errors: a tool was left out because its dimensions are impossible. Warnings: a shape cannot be imported, or
  /// numbers contradict each other (the message states which were used). Notes: assumptions.
  Diagnostics notes;
};

/// Imports a Fusion library: a JSON file, or a .tools file, which is a zip archive with that JSON file.
/// Errors   Those of a file that cannot be read as a whole: json-too-deep, json-too-long, import-syntax,
///          import-duplicate-key, import-format, import-zip. Errors of one tool are in `notes`: import-field,
///          import-shape, import-stickout, import-contradiction, import-number, import-guess, import-left-out,
///          import-empty, and those of make_body_profiles.
[[nodiscard]] Result<ImportedTools> import_fusion(const std::string& file, std::string_view bytes,
                                                  const ImportOptions& options);

/// Imports one FreeCAD tool bit (.fctb), or a library (.fctl) whose bits are read with `read_beside`. Errors: those of
/// import_fusion.
[[nodiscard]] Result<ImportedTools> import_freecad(const std::string& file, std::string_view bytes,
                                                   const ImportOptions& options);

/// Imports an NX tool_database.dat with the holders of the holder_database.dat beside it, or a holder_database.dat
/// alone. The unit is that of the options, or follows from a folder metric or english in the file's path.
/// Errors   Those of import_fusion, and import-unit.
[[nodiscard]] Result<ImportedTools> import_nx(const std::string& file, std::string_view bytes,
                                              const ImportOptions& options);

/// Imports a tool table of CAMotics, or the tools of a CAMotics project. Errors: those of import_fusion.
[[nodiscard]] Result<ImportedTools> import_camotics(const std::string& file, std::string_view bytes,
                                                    const ImportOptions& options);

/// Imports a tool table of LinuxCNC (.tbl). It states a diameter and a length for each tool, in the unit of the machine: that of
/// the options, else mm. Each tool becomes a cylinder, with an uncertainty that keeps a verdict from being clean. Errors of one
/// tool are in `notes`: import-field.
[[nodiscard]] Result<ImportedTools> import_linuxcnc(const std::string& file, std::string_view bytes,
                                                    const ImportOptions& options);

/// Returns whether each line of a text is one of a tool table of LinuxCNC.
[[nodiscard]] bool is_linuxcnc_table(std::string_view text);

/// Returns the format of a file, recognised by its content, not by its name.
[[nodiscard]] std::optional<ImportFormat> recognise_format(std::string_view bytes);

/// Imports with the importer of `format`, or of the recognised format. Errors: import-format, and those of the
/// importers above.
[[nodiscard]] Result<ImportedTools> import_tools(const std::string& file, std::string_view bytes,
                                                 std::optional<ImportFormat> format, const ImportOptions& options);

}  // namespace gouge
