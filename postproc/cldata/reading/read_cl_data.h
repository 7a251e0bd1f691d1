#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/parallel.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"

// Reads files whose statements are CL data, as words or as records.

namespace gouge {

/// Options of the user for a file; empty: recognised by its content.
struct ReadOptions {
  std::optional<Dialect> dialect;
  std::optional<LengthUnit> unit;           ///< for a file that states none
  bool is_cutcom_centre = false;            ///< positions under CUTCOM are those of the cutter's centre
  bool keeps_origins = false;               ///< keep Toolpath::origins, because the path will be rewritten
  std::optional<double> retract_plane_mm;   ///< retract plane of cycles that name a plane without its height
  std::vector<std::string> harmless_words;  ///< words of the user that cause no motion and no change
  std::string unnamed_tool;  ///< name of the tool for moves for which the file names none; empty: they have none
};

/// Either a toolpath or at least one error. At most 20 errors are listed, then one with the number of the rest.
/// Warnings and notes of a toolpath are in Toolpath::notes.
struct ReadOutcome {
  std::optional<Toolpath> toolpath;
  Diagnostics errors;
};

/// Reads a file of the given dialect, as read_toolpath does; `open` opens its statements.
[[nodiscard]] ReadOutcome read_cl_data(const std::string& file_name, SourceText bytes, const Dialect& dialect,
                                       OpenStatements open, const ReadOptions& options, const ProgressCall& progress);

}  // namespace gouge
