#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns the toolpath's file with `changes` made, in its own dialect, frame, unit and number format.
///
/// Requires `path` as read by read_toolpath. Unit axes, finite numbers.
/// Ensures  (1) Without changes the bytes are those of the file. (2) Statements that need no change are byte-identical.
///          (3) Read again, the file has the changed positions, rounded to the file's decimals (to at least 4 in mm and
///          5 in inch files). Inserted ones are separate moves of the same kind, tool and operation, or rapid ones if
///          at_rapid states so. All other moves are unchanged. (4) A straightened arc or spline has only the straight
///          positions of the file; the statement that described it is removed. (5) An arc with new_arc stays one arc.
///          Of its CIRCLE, MOVARC, INDIRV and TLON only the numbers change, in the file's own style of arcs. Positions
///          inserted before it precede all of these statements. Those that inserted_arcs reaches on an arc are preceded
///          by the arc's statement with other numbers. (6) Of a shifted hole only the numbers of its position change.
///          Its moves, and the path to the next hole, follow from them. (5) and (6) apply to the moves of
///          rewritable_moves.
/// Errors   (1) write-move: there is no such move, a move is named twice, or changes exclude each other. (2) write-arc:
///          a change is not in RewritableMoves. Or the ends of an arc do not lie on it, or its dialect would state it
///          in other words. Or the other positions of the statement of an arc or spline are not straightened with it.
///          Or an arc or spline stays but begins at a position that moves. (3) write-alone: positions are inserted
///          before a move that has no start. (4) write-axis: a position is tilted where a Mastercam NCI file cannot
///          state it.
/// Cost     One pass over the file, and one to read it again unless `path` has its origins. Memory in addition to
///          `path` is then about 5 times a usual file.
[[nodiscard]] Result<std::string> write_corrected(const Toolpath& path, const std::vector<PathChange>& changes);

/// Returns the moves of `path` that write_corrected can rewrite within its own statements.
///
/// Shape    Two entries for each move.
/// Requires `path` as read by read_toolpath.
/// Ensures  (1) A rewritable arc can be written as any arc of less than a whole turn, and as a whole turn if it is one
///          already. But an arc of CATIA stays on its side of half a turn, and the vector of a CLT arc stays. (2) An
///          arc can be split if its position is a GOTO, which is not so in CATIA. (3) A hole can be shifted if its
///          position is a GOTO. No other position may be relative to it (GODLTA), and no arc may begin where the cycle
///          ends. (4) Nothing is rewritable in Mastercam NCI and binary NCCS files. Nor are arcs whose statement
///          describes several arcs (lists of NCL), or states turns (TIMES).
/// Cost     One pass over the moves, and one to read the file again unless `path` has its origins.
[[nodiscard]] RewritableMoves rewritable_moves(const Toolpath& path);

}  // namespace gouge
