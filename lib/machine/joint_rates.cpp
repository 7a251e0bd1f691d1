#include "lib/machine/joint_rates.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

/// Returns the minutes of a feed; none: they are not known.
std::optional<double> minutes_of(const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  if (!move.has_start || runs_rapid(move) || move.runs_joints || move.feed_unit != FeedUnit::per_minute)
    return std::nullopt;
  const double length_mm = move_length_mm(path, index);
  if (!(length_mm > Tolerance::kSamePoint_mm) || !(move.feed_mm > 0)) return std::nullopt;
  return length_mm / move.feed_mm;
}

}  // namespace

std::vector<RateExcess> find_rate_excesses(const Machine& machine, const Toolpath& path) {
  std::vector<RateExcess> found;
  const auto ratio = [&](const RateExcess& one) { return one.needed / *machine.joints[one.joint].rate; };
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto &from = path.joints->start[i], &to = path.joints->end[i];
    const std::optional<double> minutes = from && to ? minutes_of(path, i) : std::nullopt;
    if (!minutes) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const RateExcess one{i, machine.rotary[k], std::abs((*to)[k] - (*from)[k]) / *minutes};
      if (machine.joints[one.joint].rate && ratio(one) > 1 + Tolerance::kSameDirection) found.push_back(one);
    }
  }
  std::ranges::stable_sort(found, std::greater(), ratio);
  return found;
}

}  // namespace gouge
