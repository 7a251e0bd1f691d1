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

/// Returns whether a RAPID in files of the dialect holds for one motion, so that a feed move can become a rapid one.
[[nodiscard]] bool can_say_rapid(std::string_view dialect);

/// Finds errors in a list of changes that do not depend on the file's statements. A move is named twice, changes
/// exclude each other, or arcs are changed in a dialect that cannot rewrite any. If it returns nothing, write_corrected
/// may examine the statements.
/// Errors   write-move, write-arc, write-alone, as in write_corrected.
[[nodiscard]] std::optional<Diagnostic> find_wrong_change(const Toolpath& path, const std::vector<PathChange>& changes);

/// Returns the edits of write_corrected for a file of text. Requires changes that write_corrected has checked.
/// Errors   write-arc, as in write_corrected.
[[nodiscard]] Result<Edits> edits_of_text(const Toolpath& path, const MotionRecords& records,
                                          const std::vector<PathChange>& changes);

/// Returns the moves of `path` that write_corrected can rewrite within its own statements.
///
/// Shape    Two entries for each move.
/// Requires `path` as read by read_toolpath, with its records.
/// Ensures  (1) A rewritable arc can be written as any arc of less than a whole turn, and as a whole turn if it is one
///          already. But an arc of CATIA stays on its side of half a turn, and the vector of a CLT arc stays. (2) An
///          arc can be split if its position is a GOTO, which is not so in CATIA. (3) A hole can be shifted if its
///          position is a GOTO. No other position may be relative to it (GODLTA), and no arc may begin where the cycle
///          ends. (4) Nothing is rewritable in Mastercam NCI and binary NCCS files. Nor are arcs whose statement
///          describes several arcs (lists of NCL), or states turns (TIMES).
/// Cost     One pass over the moves.
[[nodiscard]] RewritableMoves rewritable_moves(const Toolpath& path, const MotionRecords& records, const ArcText& arcs);

}  // namespace gouge
