#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns the toolpath's file with `changes` made, in its own dialect, frame, unit and way of writing numbers.
///
/// Requires `path` as read by read_toolpath. Unit axes, finite numbers.
/// Ensures  (1) Without changes the bytes are those of the file. (2) Statements that need no change are byte-identical.
///          (3) Read again, the file has the changed positions, rounded to the file's decimals (to at least 4 in mm and
///          5 in inch files). Inserted ones are moves of their own of the same kind, tool and operation, or rapids,
///          where at_rapid states so. All other moves are as before. (4) A straightened arc or spline is the file's own
///          straight positions instead; the statement that described it is gone. (5) An arc with new_arc is still one
///          arc. Of its CIRCLE, MOVARC, INDIRV and TLON only the numbers change, in the file's own way of writing arcs.
///          Positions inserted before it stand before all of these. Those that inserted_arcs reaches on an arc have its
///          statement with other numbers before them. (6) Of a shifted hole only the numbers of its position change.
///          Its moves, and the path to the next hole, follow from there. The moves to which (5) and (6) apply are those
///          of rewritable_moves.
/// Errors   (1) write-move: no such move, one named twice, or changes that exclude each other. (2) write-arc: a change
///          that is not in RewritableMoves. Also an arc that its ends do not lie on, or whose dialect would state it in
///          other words. Also an arc or spline whose statement's other positions are not straightened with it. Also one
///          that stays but begins at a position that moves. (3) write-alone: positions before a move that has no start.
///          (4) write-axis: a tilted position where a Mastercam NCI file cannot state one.
/// Cost     One pass over the file, and one to read it again unless `path` has its origins. Memory beyond `path` is
///          then about 5 times a usual file.
[[nodiscard]] Result<std::string> write_corrected(const Toolpath& path, const std::vector<PathChange>& changes);

/// Returns the moves of `path` that write_corrected can rewrite within its own statements.
///
/// Shape    Two entries a move.
/// Requires `path` as read by read_toolpath.
/// Ensures  (1) A rewritable arc can be written as any arc of less than a whole turn. It can be a whole turn where it
///          is one already. But CATIA's stays on its side of half a turn, and the vector of a CLT arc stays. (2) It can
///          be split where its position is a GOTO, which CATIA's is not. (3) A hole can be shifted where its position
///          is a GOTO. Nothing may be counted from that position (GODLTA), and no arc may begin where the cycle ends.
///          (4) Nothing is rewritable in Mastercam NCI and binary NCCS files. Nor are arcs of which one statement
///          describes several (lists of NCL), or that state turns (TIMES).
/// Cost     One pass over the moves, and one to read the file again unless `path` has its origins.
[[nodiscard]] RewritableMoves rewritable_moves(const Toolpath& path);

}  // namespace gouge
