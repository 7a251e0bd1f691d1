#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "lib/base/best_first_search.h"
#include "lib/check/check_options.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

// Searches over all positions of the rotary joints in a move (LawScope::any). Tools and heads share them.

namespace gouge {

/// A box of shares of the rotary joints' ways.
struct TurnBox : SearchCandidate {
  TurnShares low{0, 0}, high{1, 1};

  [[nodiscard]] TurnShares middle() const { return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])}; }
};

/// Returns both halves of a box, across the joint that turns more. `by` is the member of the spread that counts.
[[nodiscard]] inline std::array<TurnBox, 2> halves_of(const TurnBox& box, const Motion& motion,
                                                      double TurnSpread::*by) {
  const TurnShares middle = box.middle();
  const double first = motion.axis_path()->spread({box.low[0], middle[1]}, {box.high[0], middle[1]}).*by;
  const double second = motion.axis_path()->spread({middle[0], box.low[1]}, {middle[0], box.high[1]}).*by;
  const std::size_t k = first >= second ? 0 : 1;
  std::array<TurnBox, 2> halves{box, box};
  halves[0].high[k] = halves[1].low[k] = middle[k];
  return halves;
}

/// Returns the depth up to which a box needs no search: that of a clean move, or a little more than that of the gouge that
/// was found. If only the state of the move is asked, a gouge ends the search.
[[nodiscard]] inline double turn_threshold_mm(const MoveVerdict& verdict, const CheckOptions& options) {
  constexpr double kGapShare = 0.05;
  const double open_mm = options.tolerance_mm + options.resolution_mm;
  if (verdict.state != MoveState::gouge) return open_mm;
  if (options.gouge_gap_mm >= kAnyGap_mm) return std::numeric_limits<double>::infinity();
  return std::max(open_mm, (1 + kGapShare) * verdict.depth_mm + options.resolution_mm);
}

}  // namespace gouge
