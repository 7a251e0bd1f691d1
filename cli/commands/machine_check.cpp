#include "cli/commands/machine_check.h"

#include <algorithm>
#include <ostream>

#include "cli/commands/machine_words.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/law_facts.h"
#include "lib/machine/tip_slack.h"

namespace gouge {
namespace {

/// Returns the facts that a law lacks, with the options that state them; empty: none.
std::string needs_text(const Machine& machine, const std::vector<MissingFact>& missing) {
  const MachineOptionNames names;
  std::vector<std::size_t> points, rates;
  bool needs_length = false, needs_zero = false;
  for (const MissingFact& fact : missing) {
    if (fact.kind == MissingFact::Kind::point) points.push_back(fact.joint);
    if (fact.kind == MissingFact::Kind::rate) rates.push_back(fact.joint);
    needs_length = needs_length || fact.kind == MissingFact::Kind::tool_length;
    needs_zero = needs_zero || fact.kind == MissingFact::Kind::part_zero;
  }
  std::vector<std::string> needs;
  if (!points.empty())
    needs.push_back("the point of " + joints_text(machine, points) + " (" + names.joints.point + ")");
  if (needs_length) needs.push_back("the tool length (" + names.tool_length + ")");
  if (needs_zero) needs.push_back("the part zero (" + names.zero + ")");
  if (!rates.empty()) needs.push_back("the rate of " + joints_text(machine, rates) + " (" + names.joints.rate + ")");
  return listed(needs, " and ");
}

/// The same for a law that is stated together with these intervals.
std::string needs_of(const Machine& machine, TurnLaw law, const StatedMachine& stated) {
  const std::string needs = needs_text(machine, missing_facts(machine, law, stated.tool_length_mm.has_value()));
  if (tip_slack_mm(machine, {law, law}, stated.tool_length_slack_mm)) return needs;
  return needs + (needs.empty() ? "" : " and ") + "single values in place of intervals";
}

std::string use_text(const std::string& needs) { return needs.empty() ? "can be used" : "needs " + needs; }

/// A law in force for a kind of motion; none: neither an option nor the control states one.
struct LawInForce {
  std::string kind, option;
  std::optional<TurnLaw> law;
};

std::vector<LawInForce> laws_in_force(const Machine& machine, const StatedMachine& stated) {
  const MachineOptionNames names;
  const auto chosen = [](const std::string& typed, const std::optional<TurnLaw>& promised) {
    return typed.empty() ? promised : turn_law_called(typed);
  };
  return {{"feeds", names.feed_law, chosen(stated.feed_law, machine.control.feed_law)},
          {"rapids", names.rapid_law, chosen(stated.rapid_law, machine.control.rapid_law)}};
}

std::string degrees(double rad) { return display_text(rad / kDegree_rad, 0) + " deg"; }

std::string reach_text(const AxisReach& reach) {
  if (reach.most < reach.least) return "none within the limits of the rotary joints";
  const std::string from = " from the axis at joints 0";
  if (!(reach.whole < reach.most)) return "every direction up to " + degrees(reach.most) + from;
  if (reach.whole < 0) return "some directions between " + degrees(reach.least) + " and " + degrees(reach.most) + from;
  return "every direction up to " + degrees(reach.whole) + from + ", some up to " + degrees(reach.most);
}

Diagnostic describe_doubt(const Machine& machine, const MachineDoubt& doubt, const std::string& file) {
  using Kind = MachineDoubt::Kind;
  const std::string joints = joints_text(machine, doubt.joints);
  const bool is_one = doubt.joints.size() == 1;
  const std::string has = joints + (is_one ? " has" : " have");
  switch (doubt.kind) {
    case Kind::no_limits:
      return make_warning("machine-no-limits",
                          has + " no limits, so positions beyond them are not found; state min and max, or continuous",
                          file);
    case Kind::no_linear_limits:
      return make_note("machine-no-limits", has + " no limits", file);
    case Kind::no_rate:
      return make_note("machine-no-rates", has + " no rate, so feeds that need more are not found", file);
    case Kind::fixed:
      return make_warning("machine-doubt", joints + " cannot move, as min and max are equal", file);
    case Kind::idle:
      return make_warning("machine-doubt",
                          joints +
                              " turns the tool about its own axis, so no other tool axis is reached; "
                              "compare its direction with the machine",
                          file);
    case Kind::not_at_zero:
      return make_note("machine-doubt", joints + " cannot be at 0, to which the directions refer", file);
    case Kind::preference:
      return make_warning("machine-doubt", has + " limits that exclude the preferred sign", file);
  }
  return {};
}

Diagnostics doubts_of(const Machine& machine, const AxisReach& reach, const std::string& file) {
  Diagnostics all;
  if (machine.source.empty())
    all.push_back(make_warning("machine-source", "the machine has no source; state where its data come from", file));
  if (machine.control.source.empty())
    all.push_back(make_warning("machine-source", "the control has no source; state manual and page of its laws", file));
  for (const MachineDoubt& doubt : find_doubts(machine)) all.push_back(describe_doubt(machine, doubt, file));
  if (reach.whole < 0)
    all.push_back(make_warning("machine-doubt",
                               "the limits of the rotary joints exclude the tool axis at joints 0; "
                               "compare signs and limits with the machine",
                               file));
  return all;
}

}  // namespace

int check_machine(const StatedMachine& stated, std::uint64_t max_bytes, std::ostream& out, std::ostream& err) {
  std::string bytes;
  const Result<Machine> machine = load_machine(stated, max_bytes, bytes);
  if (!machine) return fail(err, {machine.error()});
  const AxisReach reach = measure_reach(*machine);
  print(err, doubts_of(*machine, reach, stated.machine));
  out << machine_row("machine", machine->name) << machine_row("tool axes", reach_text(reach));
  for (std::size_t k = 0; k < kTurnLawNames.size(); ++k) {
    const std::string needs = needs_of(*machine, static_cast<TurnLaw>(k), stated);
    const char* const kinds = k < kFeedLaws ? "feeds and rapids: " : "rapids: ";
    out << machine_row("law " + std::string(kTurnLawNames[k]), kinds + use_text(needs));
  }
  bool is_usable = true;
  for (const LawInForce& one : laws_in_force(*machine, stated)) {
    std::string text = "not given: needs " + one.option;
    if (one.law) {
      const std::string needs = needs_of(*machine, *one.law, stated);
      is_usable = is_usable && needs.empty();
      text = std::string(turn_law_name(*one.law)) + ": " + use_text(needs);
    }
    is_usable = is_usable && one.law;
    out << machine_row("law of " + one.kind, text);
  }
  return is_usable ? kExitClean : kExitNotChecked;
}

}  // namespace gouge
