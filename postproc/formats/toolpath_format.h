#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/reading/read_cl_data.h"
#include "postproc/cldata/writing/sink_options.h"
#include "postproc/program/edits.h"
#include "postproc/program/motion_sink.h"

namespace gouge {

/// Numbers of digits after the decimal point.
struct Decimals {
  int coordinates = 0, axes = 0;
};

/// Format of a toolpath file: one row of the table of formats. Several dialects share a format. No code outside the
/// table depends on the row.
struct ToolpathFormat {
  std::string_view id;  ///< value of Dialect::format
  /// Returns the dialect of a file in this format, without its byte order mark; nothing if the file has another format.
  std::optional<Dialect> (*recognise)(std::string_view bytes);
  /// Reads a file in this format, as read_toolpath does.
  ReadOutcome (*read)(const std::string& file_name, SourceText bytes, const Dialect& dialect,
                      const ReadOptions& options, const ProgressCall& progress);
  /// Returns the places of a path's moves in its file: Toolpath::origins, or else those from another reading of its
  /// bytes.
  std::shared_ptr<const MotionRecords> (*records)(const Toolpath& path);
  /// Returns the edits of write_corrected for changes that find_wrong_change accepts.
  Result<Edits> (*rewrite)(const Toolpath& path, const std::vector<PathChange>& changes);
  /// Returns the decimals that another file needs for the numbers of this one.
  Decimals (*decimals)(const Toolpath& path, const MotionRecords& records);
  /// Makes a writer; null: files in this format are only read.
  std::unique_ptr<MotionSink> (*make_sink)(const SinkOptions& options);
};

/// Returns the format by the `format` of a Dialect.
[[nodiscard]] const ToolpathFormat& format_called(std::string_view id);
[[nodiscard]] const ToolpathFormat& format_of(const Toolpath& path);

/// Recognises a dialect by the content alone, with the first format of the table that accepts it. A file without the
/// marks of any dialect is plain "apt".
[[nodiscard]] Dialect recognise_dialect(std::string_view bytes);

}  // namespace gouge
