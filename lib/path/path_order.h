#pragma once

#include <cstddef>

#include "lib/path/toolpath.h"

namespace gouge {

/// The order in which two paths cut the same positions.
struct PathOrder {
  /// Ends of feeds that each path reaches once, so that their order is certain.
  std::size_t positions = 0;
  /// The first of these positions in each path from which on the order differs; kNone: it is the same.
  std::size_t move = kNone, other = kNone;

  [[nodiscard]] bool is_same() const { return move == kNone; }
};

/// Compares the order of checked feeds. Positions nearer than `within_mm` are equal. It counts only the ends of feeds that have
/// one end of a feed of each path near. Where the order of two such positions differs, no other feed of a path may pass
/// them either. So a path that crosses itself, or repeats a pass, has no other order for that.
/// Where this is so at 1000 places, nothing is known: no position counts.
/// Cost     A sort of the moves, and passes over them for each place at which the orders differ.
[[nodiscard]] PathOrder compare_order(const Toolpath& path, const Toolpath& other, double within_mm);

}  // namespace gouge
