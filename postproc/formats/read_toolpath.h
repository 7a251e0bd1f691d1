#pragma once

#include <string>

#include "postproc/cldata/reading/read_cl_data.h"

// Reads cutter-location files: APT CL data in the forms of CAM systems, Siemens NX CLSF, binary NCCS, Mastercam NCI.
// The dialect is recognised by the content, never by the file's name, or stated by the user. docs/formats/ states which
// parts of each are understood.

namespace gouge {

/// Returns the dialect with which read_toolpath reads these bytes. That is the one of the options, else the one recognized
/// by the content.
[[nodiscard]] Dialect dialect_of(std::string_view bytes, const ReadOptions& options);

/// Units    The file's unit becomes mm; the frame of each block (NX: MSYS) becomes part coordinates.
/// Ensures  (1) Every GOTO, FROM, GOHOME, GODLTA, arc, spline or cycle point of the file is one move, or the file is
///          refused. (2) A statement that is not understood becomes a move with a reason, a counted word or a note.
/// Errors   Codes: path-empty, path-too-long, path-binary, path-not-cl-data, path-unit, path-no-motion,
///          path-part-program, path-unterminated, path-number, path-count, path-axis, path-cutter, path-tools,
///          path-statement, path-frame, path-range, path-more-errors.
/// Cost     One pass, about 300 MB/s on one core. Memory is the file, 96 bytes for each move and 12 for each statement.
///          If lines have one position each, no array is copied while it grows. That is at most 12 times the file for
///          the shortest positions (GOTO/1,1,1), and 3 times for usual positions of five axes. It is 18 times for lists
///          of positions of one digit, and 39 times for such holes, each of which is four moves. For long paths most of
///          this data is not in memory but in files (lib/base/paged_memory.h).
[[nodiscard]] ReadOutcome read_toolpath(const std::string& file_name, SourceText bytes, const ReadOptions& options = {},
                                        const ProgressCall& progress = {});

}  // namespace gouge
