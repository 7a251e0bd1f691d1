#pragma once

#include <optional>
#include <vector>

#include "lib/correct/shift_arc.h"

// An arc that is too deep in one stretch keeps the others: they stay on its own circle.

namespace gouge {

/// One of the motions that an arc becomes.
struct ArcPiece {
  Pose end;
  std::optional<PathArc> arc;  ///< none: straight
};

/// The pieces from `new_start` to `new_end` that keep every clean stretch of the arc.
///
/// `chords` are the positions strictly between its ends of straight moves that correct it.
/// Ensures  (1) A stretch that is kept has the centre, the vector and the sense of the arc, and both its ends lie on
///          it. It is clean to four fifths of the tolerance over its whole motion, and so is every other piece. (2)
///          What lies between is an arc as shift_arc ensures, or else the `chords` there. (3) At least one piece is an
///          arc, and there are no more pieces than straight moves. Nothing where that cannot be had, or the tool axis
///          turns.
/// Cost     some 30 checks of a position and 20 of an arc for each stretch.
[[nodiscard]] std::optional<std::vector<ArcPiece>> split_arc(const ArcTask& task, const std::vector<Pose>& chords,
                                                             const MotionChecker& checker);

}  // namespace gouge
