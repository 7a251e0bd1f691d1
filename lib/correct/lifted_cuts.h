#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Returns the stretches of cuts that a correction lifted or shifted from their programmed place by more than the
/// cutter's radius. The tool passes elsewhere and leaves that stock. The order is that of the path.
///
/// Requires `after` to be `path` with the changes.
/// Ensures  The length is that of the programmed feeds. For each move it is accurate to half a millimetre, or to 1/400
///          of a longer move. Cycles, rapids and stretches that are already left out (Correction::uncut) are not
///          examined.
/// Cost     Some hundred distances for each changed move.
[[nodiscard]] std::vector<Uncut> find_lifted_cuts(const Toolpath& path, const Correction& correction,
                                                  const Toolpath& after, const CheckSetup& setup);

}  // namespace gouge
