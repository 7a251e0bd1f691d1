#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/rewriting/arc_text.h"
#include "postproc/program/edits.h"

// The steps of write_corrected.

namespace gouge {

/// Returns whether files of the dialect state RAPID of one motion, so that a feed can become a rapid.
[[nodiscard]] bool can_say_rapid(std::string_view dialect);

/// Finds errors in a list of changes that do not depend on the file's statements. A move is named twice, changes
/// exclude each other, or arcs are changed where the dialect cannot rewrite any. Nothing: write_corrected may examine
/// the statements.
/// Errors   write-move, write-arc, write-alone, as write_corrected.
[[nodiscard]] std::optional<Diagnostic> find_wrong_change(const Toolpath& path, const std::vector<PathChange>& changes);

/// Returns the edits of write_corrected for a file of text. Requires changes that write_corrected has checked.
/// Errors   write-arc, as write_corrected.
[[nodiscard]] Result<Edits> edits_of_text(const Toolpath& path, const MotionRecords& records,
                                          const std::vector<PathChange>& changes);

/// Returns the moves of `path` that write_corrected can rewrite within its own statements.
///
/// Shape    Two entries a move.
/// Requires `path` as read by read_toolpath, with its records.
/// Ensures  (1) A rewritable arc can be written as any arc of less than a whole turn. It can be a whole turn where it
///          is one already. But CATIA's stays on its side of half a turn, and the vector of a CLT arc stays. (2) It can
///          be split where its position is a GOTO, which CATIA's is not. (3) A hole can be shifted where its position
///          is a GOTO. Nothing may be counted from that position (GODLTA), and no arc may begin where the cycle ends.
///          (4) Nothing is rewritable in Mastercam NCI and binary NCCS files. Nor are arcs of which one statement
///          describes several (lists of NCL), or that state turns (TIMES).
/// Cost     One pass over the moves.
[[nodiscard]] RewritableMoves rewritable_moves(const Toolpath& path, const MotionRecords& records, const ArcText& arcs);

}  // namespace gouge
