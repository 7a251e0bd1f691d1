#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// The toolpath's file with `changes` made, in its own dialect, frame, unit and way of writing numbers.
///
/// Requires `path` as read by read_toolpath. Unit axes, finite numbers.
/// Ensures  (1) Without changes the bytes are those of the file. (2) Statements that need no change are
///              byte-identical. (3) Read again, the file has the changed positions (rounded to the file's
///              decimals, to at least 4 in mm and 5 in inch files), inserted ones as moves of their own of
///              the same kind (or rapids, where at_rapid states so), tool and operation, and all other moves as before.
///              (4) A straightened arc or spline is the file's own straight positions instead; the statement that
///              described it is gone. (5) An arc with new_arc is one arc still: of its CIRCLE, MOVARC, INDIRV and TLON
///              only the numbers change, in the file's own way of writing arcs, and positions inserted before it stand
///              before all of these; those that inserted_arcs reaches on an arc have its statement with other numbers
///              before them. (6) Of a hole that is shifted the numbers of its position change and nothing else; its
///              moves, and the path to the next hole, follow from there. rewritable_moves states where (5) and (6) can
///              be had.
/// Errors   write-move (no such move, one named twice, or changes that exclude each other), write-arc (what is not in
///          RewritableMoves; an arc that its ends do not lie on, or whose dialect would state it in other
///          words; an arc or spline whose statement's other positions are not straightened with it; one that
///          stays but begins at a position that moves), write-alone (positions before a move that has no
///          start), write-axis (a tilted position where a Mastercam NCI file cannot state one).
/// Cost     One pass over the file, and one to read it again unless `path` has its origins: memory beyond `path` is then
///          about 5 times a usual file.
[[nodiscard]] Result<std::string> write_corrected(const Toolpath& path, const std::vector<PathChange>& changes);

/// Returns the moves of `path` that write_corrected can rewrite within its own statements.
///
/// Shape    Two entries a move. Requires `path` as read by read_toolpath.
/// Ensures  An arc that is rewritable can be written as any arc that turns less than a whole turn (or a whole one,
///          where it does now), but that CATIA's stays on its side of half a turn and the vector of a CLT arc stays. It
///          can be split where its position is a GOTO, which CATIA's is not. A hole can be shifted where its position
///          is a GOTO, nothing is counted from that position (GODLTA) and no arc begins where the cycle ends. Nothing
///          is rewritable in Mastercam NCI and binary NCCS files, nor arcs of which one statement describes several
///          (lists of NCL), or that state turns (TIMES).
/// Cost     One pass over the moves, and one to read the file again unless `path` has its origins.
[[nodiscard]] RewritableMoves rewritable_moves(const Toolpath& path);

}  // namespace gouge
