#pragma once

#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/rewriting/arc_text.h"

namespace gouge {

/// What write_corrected can write of `path` within its own statements.
///
/// Shape    two entries a move. Requires `path` as read by read_toolpath, with its records.
/// Ensures  an arc that is rewritable can be written as any arc that turns less than a whole turn (or a whole one,
///          where it does now), but that CATIA's stays on its side of half a turn and the vector of a CLT arc stays. It
///          can be split where its position is a GOTO, which CATIA's is not. A hole can be shifted where its position
///          is a GOTO, nothing is counted from that position (GODLTA) and no arc begins where the cycle ends. Nothing
///          is rewritable in Mastercam NCI and binary NCCS files, nor arcs of which one statement describes several
///          (lists of NCL), or that state turns (TIMES).
/// Cost     One pass over the moves.
[[nodiscard]] RewritableMoves rewritable_moves(const Toolpath& path, const MotionRecords& records, const ArcText& arcs);

}  // namespace gouge
