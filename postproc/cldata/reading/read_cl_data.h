#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/parallel.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"

// Reads the files whose statements are CL data, in words or in records.

namespace gouge {

/// Options of the user about a file; none: recognized by its content.
struct ReadOptions {
  std::optional<Dialect> dialect;
  std::optional<LengthUnit> unit;           ///< of a file that states none
  bool is_cutcom_centre = false;            ///< positions under CUTCOM are the cutter's centre
  bool keeps_origins = false;               ///< Toolpath::origins: the path is to be rewritten
  std::optional<double> retract_plane_mm;   ///< where cycles retract to that name a plane without its height
  std::vector<std::string> harmless_words;  ///< of the user's own: they move and change nothing
  std::string unnamed_tool;  ///< name of the tool of moves for which the file names none; empty: they have none
};

/// Either a toolpath or at least one error. At most 20 errors are listed, then one that counts the rest.
/// Warnings and notes of a path that was read are in Toolpath::notes.
struct ReadOutcome {
  std::optional<Toolpath> toolpath;
  Diagnostics errors;
};

/// Does read_toolpath for a file of that dialect, whose statements `open` finds.
[[nodiscard]] ReadOutcome read_cl_data(const std::string& file_name, SourceText bytes, const Dialect& dialect,
                                       OpenStatements open, const ReadOptions& options, const ProgressCall& progress);

}  // namespace gouge
