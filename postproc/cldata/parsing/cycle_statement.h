#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/path/feed.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/dialect.h"

// The canned drilling cycles. CYCLE/ states the path up and down at each of the later positions. The words of each
// dialect and their evidence: docs/formats/cycles.md.

namespace gouge {

/// Heights along the tool axis, relative to the position of a GOTO, in mm. Pecks go up and down the path of the plunge,
/// so a check need not examine them.
struct DrillCycle {
  double clearance_mm = 0;        ///< the tool goes down to here at rapid, and from here at the feed
  double bottom_mm = 0;           ///< the deepest point, usually below 0
  double retract_mm = 0;          ///< the height of the tool after the cycle
  Feed feed;                      ///< feed of the plunge; not_stated: that of FEDRAT
  bool is_fed_out = false;        ///< the tool comes up at the feed, not at rapid
  bool is_tapping = false;        ///< the spindle is reversed on the path up
  bool is_retract_stated = true;  ///< false: the statement has no retract, so it is taken as the clearance
  double csink_mm = 0;            ///< in NX: the diameter at which a pointed tool stops, in place of the bottom; else 0
  /// The position may be the top of the hole or its bottom, and the clearance a height above it or a plane of the
  /// frame. A cycle with both the lower bottom and the higher top is read.
  bool is_bounding = false;
  std::vector<double> levels_mm;  ///< if is_bounding: heights above the position at which the tool may be between holes
  std::vector<double> planes_mm;  ///< the same heights as planes of the frame
  /// false: the statement names a plane without its height, which is at least retract_mm
  bool is_retract_known = true;
  bool is_retract_left_open = false;  ///< is_retract_known is false, and no word of a retract has a number
};

/// Returns CYCLE/ON,word,value,.. of NX: the last cycle, with these values in place of its own. The arguments of the
/// last cycle are `cycle`, and those after ON are `changes`. Returns nothing if one of the words does not have exactly
/// one value.
[[nodiscard]] std::optional<std::vector<Argument>> changed_cycle(std::span<const Argument> cycle,
                                                                 std::span<const Argument> changes);

/// Reads the cycle that a CYCLE statement begins. Returns nothing if its words are not understood. That includes cycles
/// other than drilling, reaming, tapping and straight boring, and missing heights. For Autodesk ISO 4343 the result is
/// bounding, because its positions may be the top or the bottom of the hole.
[[nodiscard]] std::optional<DrillCycle> read_cycle(CycleForm form, std::span<const Argument> arguments,
                                                   double mm_per_unit);

}  // namespace gouge
