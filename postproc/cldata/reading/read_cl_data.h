#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/parallel.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/program/read_outcome.h"

// Reads files whose statements are CL data, as words or as records.

namespace gouge {

struct ProgramSetup;

/// Options of the user for a file; empty: recognised by its content.
struct ReadOptions {
  std::optional<Dialect> dialect;
  std::optional<LengthUnit> unit;               ///< for a file that states none
  bool is_cutcom_centre = false;                ///< positions under CUTCOM are those of the cutter's centre
  bool keeps_origins = false;                   ///< keep Toolpath::origins, because the path will be rewritten
  std::optional<double> retract_plane_mm;       ///< retract plane of cycles that name a plane without its height
  std::vector<std::string> harmless_words;      ///< words of the user that cause no motion and no change
  std::shared_ptr<const ProgramSetup> program;  ///< facts about a program of a control; null: none are given
  std::string unnamed_tool;  ///< name of the tool for moves for which the file names none; empty: they have none
};

/// Reads a file of the given dialect, as read_toolpath does; `open` opens its statements.
[[nodiscard]] ReadOutcome read_cl_data(const std::string& file_name, SourceText bytes, const Dialect& dialect,
                                       OpenStatements open, const ReadOptions& options, const ProgressCall& progress);

}  // namespace gouge
