#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/path/feed.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/dialect.h"

// The canned drilling cycles. CYCLE/ states the path up and down at each of its positions. The words of each dialect
// and their evidence: docs/formats/cycles.md.

namespace gouge {

/// Heights along the tool axis, counted from the position of a GOTO, in mm. Pecks go up and down the path the
/// plunge sweeps, so they add nothing to what a check must examine.
struct DrillCycle {
  double clearance_mm = 0;        ///< down to here at rapid, from here at feed
  double bottom_mm = 0;           ///< the deepest point, usually below 0
  double retract_mm = 0;          ///< where the tool is afterwards
  Feed feed;                      ///< of the plunge; not_stated: that of FEDRAT
  bool is_fed_out = false;        ///< up again at the feed, not at rapid
  bool is_tapping = false;        ///< the spindle turns back on the path up
  bool is_retract_stated = true;  ///< false: taken as the clearance, because the statement states nothing about it
  double csink_mm = 0;            ///< NX: the diameter at which a pointed tool stops, in place of the bottom; else 0
  /// The position is the top of the hole or its bottom, and the clearance a height above it or a plane of the frame.
  /// The bottom of the one and the top of the other are read.
  bool is_bounding = false;
  std::vector<double>
      levels_mm;  ///< where is_bounding: heights above the position at which the tool may be between holes
  std::vector<double> planes_mm;  ///< the same as planes of the frame
  bool is_retract_known = true;   ///< false: a plane the statement names without its height, no lower than retract_mm
  bool is_retract_left_open = false;  ///< is_retract_known is false, and no number stands with any word of a retract
};

/// Returns NX's CYCLE/ON,word,value,..: the last cycle taken up with these values in place of its own. The arguments of
/// that one are `cycle`, and those after ON are `changes`. Nothing where a word is not one with a value.
[[nodiscard]] std::optional<std::vector<Argument>> changed_cycle(std::span<const Argument> cycle,
                                                                 std::span<const Argument> changes);

/// Reads the cycle a CYCLE statement begins. Returns nothing where its words are not understood. That is so for other
/// cycles than drilling, reaming, tapping and straight boring, and for heights that are missing. It is also so for
/// Autodesk ISO 4343, whose positions may be the top or the bottom of the hole.
[[nodiscard]] std::optional<DrillCycle> read_cycle(CycleForm form, std::span<const Argument> arguments,
                                                   double mm_per_unit);

}  // namespace gouge
