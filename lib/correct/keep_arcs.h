#pragma once

#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

// Arcs that a correction has made straight become arcs again where they can.

namespace gouge {

/// Input of the search for arcs. All must outlive the call; vectors have one entry a move.
struct ArcKeeping {
  const Toolpath& path;
  const std::vector<const ToolVariants*>& tools;
  const MotionChecker& checker;
  const CorrectOptions& correct;
  const std::vector<bool>& can_rewrite;  ///< only these are examined
  const std::vector<bool>& can_split;    ///< these may become several
};

/// Lets arcs that `correction` makes straight stay arcs, in this order: one arc between the ends that they got
/// (shift_arc); one arc whose ends go on from there in the same direction, as far as all of it requires; or several, on
/// the clean stretches as they were (split_arc).
///
/// Ensures  Positions and all other moves stay as proposed, but for the two ends of an arc that both were moved: those
///          may go further, within the bounds of a shift and of --max-side-shift, where the motions beside them are
///          clean and, where those are feeds, stay on the programmed ones.
void keep_arcs(const ArcKeeping& keeping, Correction& correction);

}  // namespace gouge
