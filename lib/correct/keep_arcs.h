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

/// Lets arcs that `correction` makes straight stay arcs. It tries these in order. (1) One arc between the new ends
/// (shift_arc). (2) One arc whose ends go further in the same direction, as far as all of the arc requires. (3) Several
/// arcs on the clean stretches as they were (split_arc).
///
/// Ensures  Positions and all other moves stay as proposed, except for the two ends of an arc that were both moved.
///          Those may go further, within the bounds of a shift and of --max-side-shift. The motions beside them must
///          then be clean. Feeds beside them must stay on the programmed motions.
void keep_arcs(const ArcKeeping& keeping, Correction& correction);

}  // namespace gouge
