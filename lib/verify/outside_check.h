#pragma once

#include <string>
#include <vector>

#include "lib/verify/attack.h"
#include "lib/verify/claims.h"
#include "lib/verify/witness_check.h"

namespace gouge {

/// Result of the test whether moves that claim to be clean are outside of all solids.
struct OutsideCheck {
  std::size_t proved = 0;      ///< moves whose tool leaves the box of all surfaces without meeting one
  std::size_t sampled = 0;     ///< moves for which a winding number alone states so
  std::size_t unexamined = 0;  ///< moves of tools too thin to have a point that no surface reaches
  std::vector<Counterexample> refuted;
};

/// Tests moves that claim to be clean, by points on the tool's axis. Some lie deeper in the tool than a clean move lets
/// any surface come, so they cannot pass through a surface. Their side at one instant holds for a whole run of such
/// moves (docs/method/verify.md, "Outside"). Assumes that no move is deeper than it claims.
[[nodiscard]] OutsideCheck check_outside(const ClaimedScene& scene, const ClaimedTools& tools,
                                         const std::vector<MoveClaim>& claims);

}  // namespace gouge
