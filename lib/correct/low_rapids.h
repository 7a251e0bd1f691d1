#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Returns the rapids that a correction wrote and that come nearer to part or fixtures than its clearance, one a move
/// of the path as it was, in path order.
///
/// Measured are rapids that a change inserted, feeds that became rapids, and programmed rapids that begin or end
/// elsewhere. One of the last is listed only where it keeps less than it kept before.
/// Requires `after` to be `path` with the changes.
/// Ensures  what no entry names keeps the clearance, or as much as it did: certified by a check with the clearance
///          grown. What an entry keeps is certified too.
/// Cost     A check of each such rapid, and up to five more where it is near.
[[nodiscard]] std::vector<LowRapid> find_low_rapids(const Toolpath& path, const Correction& correction,
                                                    const Toolpath& after, const CheckSetup& setup,
                                                    const CorrectOptions& correct);

}  // namespace gouge
