#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Returns the stretches of cuts that a correction lifted, or shifted, off their programmed place by more than the
/// cutter's radius: the tool passes elsewhere, and what was cut there is not cut any more. In path order.
///
/// Requires `after` to be `path` with the changes.
/// Ensures  the length is that of the programmed feeds, known to half a millimetre a move, or to 1/400 of a longer one.
///          Cycles, rapids and what is left out already (Correction::uncut) are not looked at.
/// Cost     some hundred distances for each changed move.
[[nodiscard]] std::vector<Uncut> find_lifted_cuts(const Toolpath& path, const Correction& correction,
                                                  const Toolpath& after, const CheckSetup& setup);

}  // namespace gouge
