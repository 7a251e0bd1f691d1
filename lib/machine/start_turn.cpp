#include "lib/machine/start_turn.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/machine/kinematics.h"

namespace gouge {
namespace {

using Angles = std::vector<std::optional<RotaryAngles>>;

/// Returns the first move whose angle is beyond the limits after a shift; none: all are within them.
std::optional<std::size_t> first_beyond(const Joint& joint, const Angles& all, std::size_t k, double shift_rad) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i]) continue;
    const double angle = (*all[i])[k] + shift_rad;
    if (joint.min && angle < *joint.min - Tolerance::kSameDirection) return i;
    if (joint.max && angle > *joint.max + Tolerance::kSameDirection) return i;
  }
  return std::nullopt;
}

}  // namespace

std::vector<OtherStart> find_other_starts(const Machine& machine, const Toolpath& path) {
  std::vector<OtherStart> starts;
  const Angles& all = path.joints->end;
  const auto first = std::ranges::find_if(all, [](const auto& angles) { return angles.has_value(); });
  if (first == all.end()) return starts;
  for (std::size_t k = 0; k < 2; ++k) {
    const Joint& joint = machine.joints[machine.rotary[k]];
    const double chosen = (**first)[k];
    // The start that is farthest away is the one nearest to a limit. A start at the limit itself is none.
    const auto turns_to = [&](const std::optional<double>& limit) {
      const double room = limit ? std::abs(*limit - chosen) - Tolerance::kSameDirection : 0;
      return room > 0 ? kWholeTurn_rad * std::floor(room / kWholeTurn_rad) : 0;
    };
    for (const double shift : {-turns_to(joint.min), turns_to(joint.max)}) {
      const auto move = first_beyond(joint, all, k, shift);
      if (!(std::abs(shift) > 0) || !move) continue;
      starts.push_back({machine.rotary[k], chosen, chosen + shift, *move});
      break;
    }
  }
  return starts;
}

}  // namespace gouge
