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
  std::size_t samples = 0;  ///< instants examined
  std::size_t moves = 0;    ///< of how many moves, each without a proof at least once
  std::optional<Counterexample> found;
};

/// Searches for points deeper than `claims` allow, at the end of every move without a proof and then at random instants
/// of all moves. It finds the point of the surface that is deepest in the tool (or a head), best first. It climbs from
/// there over its triangle and over time. A point that it does not find may exist all the same.
///
/// `orders`     Those of the scene.
/// `is_proved`  One a move.
/// `seconds`    The minimum duration. With 0: these ends and some thousand instants more, the same on every run.
[[nodiscard]] AttackResult attack_claims(const ClaimedScene& scene, const SceneOrders& orders,
                                         const ClaimedTools& tools, const std::vector<MoveClaim>& claims,
                                         const std::vector<bool>& is_proved, double seconds);

}  // namespace gouge
