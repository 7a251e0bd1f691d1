#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/toolpath.h"

namespace gouge {

/// Time and lengths of some moves at the feeds that the file states. Lengths are those of the tip's path.
struct CycleTime {
  double feed_seconds = 0;              ///< time of all moves with a feed per minute
  double feed_mm = 0;                   ///< their length
  double rapid_mm = 0;                  ///< length of rapids; the file does not state their speed
  double open_mm = 0;                   ///< length of all other moves
  std::size_t rapids = 0;               ///< number of rapids
  std::size_t moves_per_turn = 0;       ///< number of moves with a feed per revolution of the spindle
  std::size_t moves_without_feed = 0;   ///< number of other moves whose feed is not known
  std::size_t moves_without_start = 0;  ///< number of single positions, to which no motion is known

  void add(const CycleTime& other);
  /// Returns whether each feed move has a time.
  [[nodiscard]] bool is_whole() const { return moves_per_turn + moves_without_feed + moves_without_start == 0; }
};

/// Returns the times of the operations of a path, in their order, and last that of the moves without an operation. A
/// feed of a motion of joints without tool centre point control is not known: its tip has another speed.
/// Cost: one pass over the moves.
[[nodiscard]] std::vector<CycleTime> measure_cycle_times(const Toolpath& path);

}  // namespace gouge
