#pragma once

#include <cstdint>

#include "lib/tool/motion_tube.h"

namespace gouge {

/// Options of the check against remaining stock. Lengths in mm.
struct StockOptions {
  double tolerance_mm = 0.1;    ///< maximum depth of remaining stock in a body that is no collision
  double resolution_mm = 0.05;  ///< cutters count as wider by this much, so slivers below twice this count as removed
  MotionTube tube = {};         ///< largest departure of the tools from their motions
  std::uint64_t budget_per_group = 2'000'000;  ///< number of pieces for 256 moves, after which each gets the least
  std::uint64_t least_budget = 5'000;          ///< number of pieces that every move may take
  std::uint64_t budget_per_move = 200'000;     ///< number of pieces after which a move is "not certified"
  std::uint64_t budget_per_bound = 60'000;     ///< the same for the depth of a finding, and for its first contact
};

}  // namespace gouge
