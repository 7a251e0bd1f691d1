#pragma once

#include <cstddef>
#include <cstdint>

#include "lib/motion/motion_law.h"

namespace gouge {

/// What the check is asked. Lengths in mm.
struct CheckOptions {
  double tolerance_mm = 0.01;                 ///< depth a move may have (bodies with a clearance: 0)
  double resolution_mm = 0.001;               ///< certified gap
  double gouge_gap_mm = 0;                    ///< gap to which the depth of a gouge is closed; 0: the resolution
  double stock_to_leave_mm = 0;               ///< grows the cutter against the part
  double shank_clearance_mm = 0;              ///< grows the shank
  double holder_clearance_mm = 0;             ///< grows the holder
  double near_miss_mm = 0;                    ///< 0: not asked
  bool is_depth_alone = false;                ///< how far thin and pointed features reach into a solid is not asked
  MotionLaw law;                              ///< how the tool moves between positions
  unsigned threads = 0;                       ///< 0: all
  std::uint64_t budget_per_move = 2'000'000;  ///< bounds computed before a move is "not certified"
};

}  // namespace gouge
