#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Returns the rapids that a correction wrote and that come nearer to part or fixtures than its clearance. There is one
/// entry a move of the path as it was, in path order.
///
/// Measured are rapids that a change inserted, feeds that became rapids, and programmed rapids that begin or end
/// elsewhere. One of the last is listed only where it keeps less than it kept before.
/// Requires `after` to be `path` with the changes.
/// Ensures  A rapid without an entry keeps the clearance, or as much as it did. A check with the clearance grown
///          certifies that, and the clearance of each entry too.
/// Cost     A check of each such rapid, and up to five more where it is near.
[[nodiscard]] std::vector<LowRapid> find_low_rapids(const Toolpath& path, const Correction& correction,
                                                    const Toolpath& after, const CheckSetup& setup,
                                                    const CorrectOptions& correct);

}  // namespace gouge
