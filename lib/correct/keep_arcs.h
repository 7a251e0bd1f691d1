#pragma once

#include <vector>

#include "lib/certify/motion_checker.h"
#include "lib/correct/correct_path.h"

// Arcs that a correction has replaced by straight moves become arcs again if possible.

namespace gouge {

/// Input of the search for arcs. All objects must outlive the call; vectors have one entry for each move.
struct ArcKeeping {
  const Toolpath& path;
  const std::vector<const ToolVariants*>& tools;
  const MotionChecker& checker;
  const CorrectOptions& correct;
  const std::vector<bool>& can_rewrite;  ///< arcs that are examined
  const std::vector<bool>& can_split;    ///< arcs that may become several arcs
};

/// Makes arcs again of those that `correction` replaces by straight moves. It tries these forms in order. (1) One arc
/// between the new ends (shift_arc). (2) One arc whose ends are shifted farther in the same direction, as far as the
/// whole arc requires. (3) Several arcs on the clean stretches of the original arc (split_arc).
///
/// Ensures  Positions and all other moves stay as proposed, except for the two ends of an arc that were both moved.
///          These may move farther, within the bounds of a shift and of --max-side-shift. The motions next to them must
///          then be clean. Feeds next to them must stay on the programmed motions.
void keep_arcs(const ArcKeeping& keeping, Correction& correction);

}  // namespace gouge
