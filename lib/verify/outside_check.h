#pragma once

#include <string>
#include <vector>

#include "lib/verify/attack.h"
#include "lib/verify/claims.h"
#include "lib/verify/witness_check.h"

namespace gouge {

/// Result of the test whether moves that claim to be clean are outside of all solids.
struct OutsideCheck {
  std::size_t proved = 0;      ///< moves whose tool provably leaves the box of all surfaces without meeting a surface
  std::size_t sampled = 0;     ///< moves for which only a winding number states that they are outside
  std::size_t unexamined = 0;  ///< moves of tools that are too thin to have a point that no surface reaches
  std::vector<Counterexample> refuted;
};

/// Tests moves that claim to be clean, by points on the tool's axis. Some of these points are deeper in the tool than a
/// clean move allows for any surface. So they cannot pass through a surface. Their side at one instant holds for a
/// whole sequence of such moves (docs/method/verify.md, "Outside"). Assumes that no move is deeper than it claims.
[[nodiscard]] OutsideCheck check_outside(const ClaimedScene& scene, const ClaimedTools& tools,
                                         const std::vector<MoveClaim>& claims);

}  // namespace gouge
