#include "cli/machine/rate_notes.h"

#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/joint_rates.h"
#include "lib/machine/law_facts.h"

namespace gouge {
namespace {

std::string rate_text(double rad) { return display_text(rad / kDegree_rad, 0) + " deg/min"; }

}  // namespace

Diagnostics describe_rate_excesses(const Machine& machine, const std::optional<TurnLaw>& feeds, const Toolpath& path) {
  constexpr std::size_t kMaxNotes = 20;
  if (feeds && runs_joints(*feeds)) return {};
  const std::vector<RateExcess> excesses = find_rate_excesses(machine, path);
  Diagnostics notes;
  for (const RateExcess& one : excesses) {
    if (notes.size() == kMaxNotes) break;
    const Joint& joint = machine.joints[one.joint];
    const Move& move = path.moves[one.move];
    const double feed = move.feed_mm / mm_per(path.unit);
    notes.push_back(make_warning("machine-rate",
                                 "joint " + joint.name + " needs " + rate_text(one.needed) +
                                     " on average at the feed of " + display_text(feed, 3) + " " +
                                     unit_name(path.unit) + "/min; its rate is " + rate_text(*joint.rate),
                                 path.file, move.line));
  }
  if (excesses.size() > kMaxNotes)
    notes.push_back(make_note(
        "machine-more", std::to_string(excesses.size() - kMaxNotes) + " more moves exceed the rate of a joint by less",
        path.file));
  return notes;
}

}  // namespace gouge
