#pragma once

#include <optional>
#include <vector>

#include "lib/certify/motion_checker.h"

// An arc that must change stays an arc where one can be found. It is the same circle elsewhere, or an arc about a
// centre that its new ends require.

// An arc that is too deep in one stretch keeps the others: they stay on its own circle.

namespace gouge {

/// An arc whose ends go elsewhere.
struct ArcTask {
  PathArc arc;
  Pose start, end;          ///< as they are
  Pose new_start, new_end;  ///< with the same tool axes
  MoveKind kind = MoveKind::arc;
  const ToolVariants* tool = nullptr;
};

/// Finds the arc from `new_start` to `new_end` that changes least and is clean.
///
/// Requires the end poses of an arc of one turn at most.
/// Ensures  (1) The vector and the way round are the same. Both ends are equally far from its centre line, and as high
///          above each other as they were, to a fifth of the tolerance. A full circle stays one. (2) It is clean to
///          four fifths of the tolerance over its whole motion (check_move), which leaves a margin for the digits of
///          the file. (3) No part of the arc that fits is given up for another. No position goes further than the
///          tolerance and twice its depth, unless nine tenths of the arc were too deep. Seventeen positions are
///          examined. Those that are too deep or go further than the tolerance may be shifted there (why_not_shift).
/// Tried    The centre shifted with the ends; the centre line kept, with another radius; each moved to where both ends
///          are equally far.
[[nodiscard]] std::optional<PathArc> shift_arc(const ArcTask& task, const MotionChecker& checker);

/// One of the motions that an arc becomes.
struct ArcPiece {
  Pose end;
  std::optional<PathArc> arc;  ///< none: straight
};

/// Finds the pieces from `new_start` to `new_end` that keep every clean stretch of the arc.
///
/// The `chords` are the positions, strictly between its ends, of straight moves that correct it.
/// Ensures  (1) A stretch that is kept has the centre, the vector and the sense of the arc, and both its ends lie on
///          it. It is clean to four fifths of the tolerance over its whole motion, and so is every other piece. (2)
///          Each stretch between is an arc as shift_arc ensures, or else the `chords` there. (3) At least one piece is
///          an arc, and there are no more pieces than straight moves. Nothing is returned where that is impossible, or
///          where the tool axis turns.
/// Cost     Some 30 checks of a position and 20 of an arc for each stretch.
[[nodiscard]] std::optional<std::vector<ArcPiece>> split_arc(const ArcTask& task, const std::vector<Pose>& chords,
                                                             const MotionChecker& checker);

}  // namespace gouge
