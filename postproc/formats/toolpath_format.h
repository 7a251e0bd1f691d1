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

/// Digits behind the decimal point.
struct Decimals {
  int coordinates = 0, axes = 0;
};

/// Format of a toolpath file: one row of the table of formats. Several dialects share a
/// format. No code outside that table depends on the row.
struct ToolpathFormat {
  std::string_view id;  ///< Dialect::format
  /// The dialect of a file in this format, without its byte order mark; nothing where it is in another one.
  std::optional<Dialect> (*recognise)(std::string_view bytes);
  /// read_toolpath for a file in this format.
  ReadOutcome (*read)(const std::string& file_name, SourceText bytes, const Dialect& dialect,
                      const ReadOptions& options, const ProgressCall& progress);
  /// Returns where the moves of a path stand in its file: Toolpath::origins, or else another reading of its bytes.
  std::shared_ptr<const MotionRecords> (*records)(const Toolpath& path);
  /// write_corrected for changes that find_wrong_change accepts.
  Result<Edits> (*rewrite)(const Toolpath& path, const std::vector<PathChange>& changes);
  /// Decimals that another file needs to hold the numbers of this one.
  Decimals (*decimals)(const Toolpath& path, const MotionRecords& records);
  /// Null: files in this format are only read.
  std::unique_ptr<MotionSink> (*make_sink)(const SinkOptions& options);
};

/// Requires the `format` of a Dialect.
[[nodiscard]] const ToolpathFormat& format_called(std::string_view id);
[[nodiscard]] const ToolpathFormat& format_of(const Toolpath& path);

/// Recognises a dialect by the content alone: the first format of the table that accepts it. A file without marks of
/// any is plain "apt".
[[nodiscard]] Dialect recognise_dialect(std::string_view bytes);

}  // namespace gouge
