#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/check/closest_approach.h"
#include "lib/check/path_fit.h"
#include "lib/check/verdict.h"
#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// The verdict on a whole path. verdicts.size() == toolpath.moves.size(); every move has one state.
struct CheckResult {
  MoveVerdicts verdicts;
  std::vector<Event> events;  ///< in path order
  StateCounts counts;
  double worst_depth_mm = 0;
  std::size_t worst_move = static_cast<std::size_t>(-1);
  double worst_overcut_mm = 0;                      ///< largest overcut of a gouge; 0 where none was measured
  double largest_gap_mm = 0;                        ///< largest depth_upper - depth over gouging moves
  std::uint64_t evaluations = 0;                    ///< bounds computed; the same on every run
  Assumptions assumptions;                          ///< on which the verdict rests; empty where only moves were checked
  std::optional<ClosestApproach> closest_approach;  ///< none: not measured, or nothing to measure
  PathFit fit;                                      ///< fits where it was not requested
};

/// Fills the events, the counts and the worst move of a result from its verdicts, anew.
///
/// Neighbouring moves of one state, tool, operation, body and counterpart are one event, in path order; buried ones
/// only with the same reason. Clean and not-checked moves are not in events.
void summarise(const Toolpath& toolpath, CheckResult& result);

}  // namespace gouge
