#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/verify/claims.h"
#include "lib/verify/triangle_order.h"
#include "lib/verify/witness_check.h"

namespace gouge {

/// A point of the surface that is deeper in the tool than a claim allows.
struct Counterexample {
  std::size_t move = 0;
  double t = 0;
  Vec3 point = Vec3::Zero();
  std::string what;
};

struct AttackResult {
  std::size_t samples = 0;  ///< number of examined instants
  std::size_t moves = 0;    ///< number of moves with a bound; each move without a proof was examined at least once
  std::optional<Counterexample> found;
};

/// Searches for points deeper than `claims` allow: at the end of every move without a proof, then at random instants of
/// all moves. At an instant a best-first search finds the point of the surface that is deepest in the tool (or a head).
/// From there it climbs to deeper points over its triangle and over time. Such points may exist even if the search
/// finds none.
///
/// `orders`     The triangle orders of the scene.
/// `is_proved`  One entry for each move.
/// `seconds`    The minimum duration. With 0: the ends of moves and a few thousand more instants, the same in every
/// run.
[[nodiscard]] AttackResult attack_claims(const ClaimedScene& scene, const SceneOrders& orders,
                                         const ClaimedTools& tools, const std::vector<MoveClaim>& claims,
                                         const std::vector<bool>& is_proved, double seconds);

}  // namespace gouge
