#pragma once

#include <vector>

#include "lib/correct/correct_path.h"

namespace gouge {

/// Returns the rapids that a correction wrote and that come nearer to part or fixtures than the clearance. There is one
/// entry for each such move of the original path, in path order.
///
/// It measures rapids that a change inserted, feeds that became rapids, and programmed rapids with a new start or end.
/// A programmed rapid is listed only if it keeps less distance than before.
/// Requires `after` to be `path` with the changes.
/// Ensures  A rapid without an entry keeps the clearance, or as much distance as before. A check with a larger
///          clearance certifies that, and certifies the distance of each entry too.
/// Cost     A check of each such rapid, and up to five more if it is near.
[[nodiscard]] std::vector<LowRapid> find_low_rapids(const Toolpath& path, const Correction& correction,
                                                    const Toolpath& after, const CheckSetup& setup,
                                                    const CorrectOptions& correct);

}  // namespace gouge
