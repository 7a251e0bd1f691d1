#include "cli/machine/rate_notes.h"

#include <algorithm>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/joint_rates.h"
#include "lib/machine/law_facts.h"

namespace gouge {
namespace {

std::string rate_text(double rad) { return display_text(rad / kDegree_rad, 0) + " deg/min"; }

}  // namespace

Diagnostics describe_rate_excesses(const Machine& machine, const std::optional<TurnLaw>& feeds, const Toolpath& path) {
  if (feeds && runs_joints(*feeds)) return {};
  const std::vector<RateExcess> excesses = find_rate_excesses(machine, path);
  Diagnostics notes;
  for (std::size_t joint = 0; joint < machine.joints.size(); ++joint) {
    const auto worst = std::ranges::find(excesses, joint, &RateExcess::joint);
    if (worst == excesses.end()) continue;
    const std::ptrdiff_t count = std::ranges::count(excesses, joint, &RateExcess::joint);
    const Move& move = path.moves[worst->move];
    const double feed = move.feed_mm / mm_per(path.unit);
    notes.push_back(
        make_warning("machine-rate",
                     "joint " + machine.joints[joint].name + " needs " + rate_text(worst->needed) +
                         " on average at the feed of " + display_text(feed, 3) + " " + unit_name(path.unit) +
                         "/min; its rate is " + rate_text(*machine.joints[joint].rate) +
                         (count == 1 ? "" : "; this is the worst of " + std::to_string(count) + " such feeds"),
                     path.file, move.line));
  }
  return notes;
}

}  // namespace gouge
