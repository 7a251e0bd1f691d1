#pragma once

#include <optional>
#include <vector>

#include "lib/certify/motion_checker.h"

// An arc that must change stays an arc if possible: the same circle at another place, or an arc about a centre that its
// new ends require.

// An arc that is too deep in one stretch keeps its other stretches on its own circle.

namespace gouge {

/// An arc whose ends move.
struct ArcTask {
  PathArc arc;
  Pose start, end;          ///< the present ends
  Pose new_start, new_end;  ///< the new ends, with the same tool axes
  MoveKind kind = MoveKind::arc;
  const ToolVariants* tool = nullptr;
};

/// Finds the arc from `new_start` to `new_end` that changes least and is clean.
///
/// Requires the end poses of an arc of at most one turn.
/// Ensures  (1) The vector and the sense of rotation are the same. Both ends are equally far from the centre line.
///          Their difference in height is the same as before, to a fifth of the tolerance. A full circle stays one. (2)
///          The arc is clean to four fifths of the tolerance over its whole motion (check_move), which leaves a margin
///          for the digits of the file. (3) No good part of the arc is sacrificed for a bad one. No position moves
///          farther than the tolerance plus twice its depth, unless nine tenths of the arc were too deep. Seventeen
///          positions are examined. If one is too deep or moves farther than the tolerance, its shift must be permitted
///          (why_not_shift).
/// Tried    The centre shifted with the ends; the same centre line with another radius. Each centre is then moved to be
///          equally far from both ends.
[[nodiscard]] std::optional<PathArc> shift_arc(const ArcTask& task, const MotionChecker& checker);

/// One of the motions that replace an arc.
struct ArcPiece {
  Pose end;
  std::optional<PathArc> arc;  ///< none: a straight motion
};

/// Finds the pieces from `new_start` to `new_end` that keep every clean stretch of the arc.
///
/// The `chords` are the positions, strictly between its ends, of straight moves that correct it.
/// Ensures  (1) A stretch that is kept has the centre, the vector and the sense of the arc, and both its ends lie on
///          the arc. It is clean to four fifths of the tolerance over its whole motion, and so is every other piece.
///          (2) Each stretch between is an arc of shift_arc, or else consists of the `chords` there. (3) At least one
///          piece is an arc, and there are no more pieces than straight moves. Nothing is returned if that is
///          impossible, or if the tool axis turns.
/// Cost     Some 30 checks of a position and 20 of an arc for each stretch.
[[nodiscard]] std::optional<std::vector<ArcPiece>> split_arc(const ArcTask& task, const std::vector<Pose>& chords,
                                                             const MotionChecker& checker);

}  // namespace gouge
