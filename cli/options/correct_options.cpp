#include "cli/options/correct_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "cli/options/length_rule.h"
#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "lib/base/similar_name.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"

namespace gouge {
namespace {

constexpr double kMaxTilt = 89, kMaxCone = 180, kMaxTurn = 1e6;

constexpr const char* kExpectedStrategy =
    "auto, tilt, normal, weighted, axis, trim or direction=I,J,K, for all bodies or after cutter=, shank=, holder= or head= "
    "for one";
constexpr std::string_view kDirection = "direction=";

Result<double> understand_degrees(const std::string& option, const std::string& typed, double most) {
  const auto value = parse_number(typed);
  if (value && *value > 0 && *value <= most) return *value * kDegree_rad;
  return usage_error(option, typed, "degrees above 0 and at most " + display_text(most, 0));
}

/// The strategy called `name` for `body`; nothing where there is none.
std::optional<Strategy> strategy_called(const std::string& name, std::size_t body) {
  if (name == "auto") return BodyStrategies{}.of[body];
  for (const Strategy strategy :
       {Strategy::weighted, Strategy::axis, Strategy::tilt, Strategy::normal, Strategy::trim}) {
    if (name == strategy_name(strategy)) return strategy;
  }
  return name.starts_with(kDirection) ? std::optional(Strategy::direction) : std::nullopt;
}

std::optional<Vec3> direction_of(const std::vector<double>& numbers) {
  const Vec3 vector(numbers[0], numbers[1], numbers[2]);
  return vector.norm() > Tolerance::kNoSide && vector.norm() < 1e6 ? std::optional<Vec3>(vector.normalized())
                                                                   : std::nullopt;
}

/// [BODY=]NAME; the body is empty where it is for all.
struct NamedStrategy {
  std::string typed, body, name;
};

NamedStrategy divide(const std::string& typed) {
  const std::size_t equals = typed.starts_with(kDirection) ? std::string::npos : typed.find('=');
  if (equals == std::string::npos) return {typed, "", typed};
  return {typed, typed.substr(0, equals), typed.substr(equals + 1)};
}

/// Returns the error for a value that names no strategy or no body, with the name that was probably meant.
Diagnostic unknown_strategy(const NamedStrategy& one) {
  const std::string body = one.body.empty() ? "" : find_similar_name(one.body, {"cutter", "shank", "holder", "head"});
  const std::string name = find_similar_name(one.name, {"auto", "tilt", "normal", "weighted", "axis", "trim"});
  const bool is_meant = !name.empty() && (one.body.empty() || !body.empty());
  const std::string meant = (body.empty() ? "" : body + "=") + name;
  return usage_error("--strategy", one.typed,
                     kExpectedStrategy + (is_meant ? "; did you mean " + meant + "?" : std::string()));
}

/// A value for one body holds for that body, wherever it stands.
Result<BodyStrategies> understand_strategies(const std::vector<std::string>& all) {
  constexpr std::array kBodies = {Body::cutter, Body::shank, Body::holder, Body::head};
  std::vector<NamedStrategy> given;
  for (const std::string& typed : all) given.push_back(divide(typed));
  std::stable_partition(given.begin(), given.end(), [](const NamedStrategy& one) { return one.body.empty(); });
  BodyStrategies strategies;
  std::set<std::string> bodies;
  for (const NamedStrategy& of : given) {
    const auto& [one, wanted, name] = of;
    bool is_any = false;
    if (one.starts_with('=')) return unknown_strategy(of);
    if (!bodies.insert(wanted).second)
      return usage_error("--strategy", one,
                         wanted.empty() ? "one strategy for all bodies" : "one strategy for " + wanted);
    for (const Body body : kBodies) {
      if (!wanted.empty() && wanted != body_name(body)) continue;
      const auto index = static_cast<std::size_t>(body);
      const auto strategy = strategy_called(name, index);
      // A cutter that gouges is inside the surface that it shall keep to: no tilt about the contact frees it.
      if (!strategy || (wanted == "cutter" && *strategy == Strategy::tilt))
        return strategy ? usage_error("--strategy", one, "no tilt for the cutter: it shifts") : unknown_strategy(of);
      if (*strategy == Strategy::direction) {
        const auto numbers = parse_numbers(name.substr(kDirection.size()), 3);
        const auto direction = numbers ? direction_of(*numbers) : std::nullopt;
        if (!direction) return usage_error("--strategy", one, "three numbers of a direction, as in direction=0,0,1");
        strategies.direction = *direction;
      }
      strategies.of[index] =
          body == Body::cutter && *strategy == Strategy::tilt ? BodyStrategies::kOfCutter : *strategy;
      is_any = true;
    }
    if (!is_any) return unknown_strategy(of);
  }
  return strategies;
}

Result<AxisCone> understand_cone(const std::string& typed) {
  const auto wrong = [&] {
    return usage_error("--axis-cone", typed, "I,J,K,DEGREES: a direction and an angle above 0 and at most 180");
  };
  const auto numbers = parse_numbers(typed, 4);
  const auto axis = numbers ? direction_of(*numbers) : std::nullopt;
  const double degrees = numbers ? numbers->back() : 0;
  if (!axis || !(degrees > 0) || degrees > kMaxCone) return wrong();
  return AxisCone{*axis, degrees * kDegree_rad};
}

Result<TiltOptions> understand_tilt(const CorrectArguments& arguments) {
  TiltOptions tilt;
  const Result<double> most = understand_degrees("--max-tilt", arguments.max_tilt, kMaxTilt);
  if (!most) return most.error();
  tilt.max_tilt_rad = *most;
  if (arguments.tilt == "lead") tilt.freedom = TiltFreedom::lead;
  if (arguments.tilt == "side") tilt.freedom = TiltFreedom::side;
  if (!arguments.axis_cone.empty()) {
    const Result<AxisCone> cone = understand_cone(arguments.axis_cone);
    if (!cone) return cone.error();
    tilt.cone = *cone;
  }
  if (!arguments.max_turn.empty()) {
    const Result<double> turn = understand_degrees("--max-turn", arguments.max_turn, kMaxTurn);
    if (!turn) return turn.error();
    tilt.max_turn_rad_per_mm = *turn;
  }
  if (!arguments.max_turn_step.empty()) {
    const Result<double> step = understand_degrees("--max-turn-step", arguments.max_turn_step, kMaxCone);
    if (!step) return step.error();
    tilt.max_turn_step_rad = *step;
  }
  const Result<double> blend = understand_length("--blend", arguments.blend, Minimum::above_zero);
  if (!blend) return blend.error();
  tilt.blend_mm = *blend;
  const Result<double> stock = understand_length("--allow-stock", arguments.max_stock, Minimum::zero);
  if (!stock) return stock.error();
  tilt.max_stock_mm = *stock;
  return tilt;
}

}  // namespace

Result<CorrectOptions> understand_correction(const CorrectArguments& arguments) {
  CorrectOptions options;
  const Result<BodyStrategies> strategies = understand_strategies(arguments.strategies);
  if (!strategies) return strategies.error();
  options.strategies = *strategies;
  const Result<TiltOptions> tilt = understand_tilt(arguments);
  if (!tilt) return tilt.error();
  options.tilt = *tilt;
  options.may_add_axes = arguments.may_add_axes;
  const Result<double> shift = understand_length("--max-shift", arguments.max_shift, Minimum::above_zero);
  if (!shift) return shift.error();
  options.max_shift_mm = *shift;
  const Result<double> clearance = understand_length("--rapid-clearance", arguments.rapid_clearance, Minimum::zero);
  if (!clearance) return clearance.error();
  options.rapid_clearance_mm = *clearance;
  if (arguments.max_side_shift.empty()) return options;
  const Result<double> side_shift = understand_length("--max-side-shift", arguments.max_side_shift, Minimum::zero);
  if (!side_shift) return side_shift.error();
  options.max_side_shift_mm = *side_shift;
  return options;
}

std::string strategies_text(const CorrectArguments& arguments) {
  std::string text;
  for (const std::string& one : arguments.strategies) text += (text.empty() ? "" : ", ") + one;
  return text.empty() ? "auto" : text;
}

namespace {

OptionRows<CorrectArguments> shift_rows() {
  using A = CorrectArguments;
  return {{.name = "-o,--output",
           .field = &A::output,
           .type = "FILE",
           .group = kOutputGroup,
           .help = "Corrected toolpath, in the dialect of the input (- for standard output, without other text)",
           .is_required = true},
          {.name = "--strategy",
           .field = &A::strategies,
           .type = "[BODY=]NAME",
           .group = "Correction",
           .help = "Strategy for all bodies, or for one body: holder=tilt (repeatable; default: auto). auto: normal "
                   "for the cutter, tilt for shank, holder and heads. tilt: tilt the tool about the contact. normal: "
                   "shift along the normal of the deepest contact. weighted: shift by the weighted mean of the "
                   "contacts. direction=I,J,K: shift along this direction. If one of these fails, the tool is lifted "
                   "along its axis. axis: only lift along the tool axis. trim: leave out the gouging stretch "
                   "(retract, cross, plunge)",
           .scope = Scope::project},
          {.name = "--max-shift",
           .field = &A::max_shift,
           .type = "LENGTH",
           .help = "Maximum distance by which a position may be moved",
           .scope = Scope::project},
          {.name = "--max-side-shift",
           .field = &A::max_side_shift,
           .type = "LENGTH",
           .help = "Maximum distance by which a position may be moved across its tool axis (default: twice its depth)",
           .scope = Scope::project},
          {.name = "--rapid-clearance",
           .field = &A::rapid_clearance,
           .type = "LENGTH",
           .help = "Clearance of rerouted rapid moves and of crossings above trimmed stretches, if a shift within "
                   "--max-shift gives it",
           .scope = Scope::project}};
}

OptionRows<CorrectArguments> tilt_rows() {
  using A = CorrectArguments;
  return {{.name = "--max-tilt",
           .field = &A::max_tilt,
           .type = "DEG",
           .help = "Maximum angle between a tilted tool axis and the programmed one",
           .scope = Scope::project,
           .recorded = Recorded::shown},
          {.name = "--tilt",
           .field = &A::tilt,
           .help = "Direction of tilts: lead, forward and backward in the feed direction; side, to the sides of it; "
                   "both",
           .scope = Scope::project,
           .recorded = Recorded::shown,
           .choices = {"lead", "side", "both"}},
          {.name = "--axis-cone",
           .field = &A::axis_cone,
           .type = "I,J,K,DEG",
           .help = "Keep tilted tool axes within DEG of the direction I,J,K, such as the range of the machine",
           .scope = Scope::project,
           .recorded = Recorded::shown},
          {.name = "--max-turn",
           .field = &A::max_turn,
           .type = "DEG/MM",
           .help = "Maximum turn of the tool axis per mm, except where the programmed turn is faster",
           .scope = Scope::project,
           .recorded = Recorded::shown},
          {.name = "--max-turn-step",
           .field = &A::max_turn_step,
           .type = "DEG",
           .help = "Maximum turn of the tool axis in one record, in degrees",
           .scope = Scope::project,
           .recorded = Recorded::shown},
          {.name = "--blend",
           .field = &A::blend,
           .type = "LENGTH",
           .help = "Arc length over which a tilt begins and ends, if the path is long enough",
           .scope = Scope::project,
           .recorded = Recorded::shown,
           .result_text = with_units},
          {.name = "--allow-stock",
           .field = &A::max_stock,
           .type = "LENGTH",
           .help = "Maximum stock above the tolerance that a tilt may leave where the programmed path finished the "
                   "part. If any change leaves more stock, the stock is reported",
           .recorded = Recorded::shown,
           .result_text = with_units},
          {.name = "--allow-multax",
           .field = &A::may_add_axes,
           .help = "Permit tilts in a file that states no tool axes. The corrected file then needs five axes",
           .scope = Scope::project,
           .recorded = Recorded::shown},
          {.name = "--max-rotary-speed",
           .field = &A::max_rotary_speed,
           .type = "DEG/MIN",
           .help = "Maximum turning speed of the tool axis: the report also states the feed time within this limit. "
                   "It changes no correction",
           .scope = Scope::project,
           .recorded = Recorded::shown},
          {.name = "--force",
           .field =
               +[](CLI::App& command, A& a) {
                 command.add_flag(
                     "--force", a.job.is_forced,
                     "Correct a path even if it clearly does not fit the part (units, placement, axis sign). Let "
                     "--report replace and remove files that have names of a report but were not written by one, "
                     "except inputs");
               },
           .group = kOutputGroup}};
}

}  // namespace

const OptionRows<CorrectArguments>& correct_options() {
  static const OptionRows<CorrectArguments> rows = [] {
    OptionRows<CorrectArguments> all = shift_rows();
    std::ranges::move(tilt_rows(), std::back_inserter(all));
    return all;
  }();
  return rows;
}

void add_correct_options(CLI::App& command, CorrectArguments& arguments) {
  add_job_options(command, arguments.job);
  add_options(command, arguments.job, stock_options());
  add_options(command, arguments, correct_options());
  command.footer(
      "Example:\n"
      "  gougecheck correct finish.apt --part part.stl --tools tools.json -o out.apt\n\n"
      "The corrected file is read again and checked like any other toolpath. Records that need no change stay "
      "byte for byte. A clean move stays clean. No move becomes deeper or buried.\n\n"
      "Exit status: 0 the corrected path is clean; 1 gouges remain and are listed with the reason, or the path "
      "does not fit the part and nothing was written; 2 wrong command line; 3 input unreadable or invalid; 4 not "
      "fully checked; 5 internal or resource failure.");
}

}  // namespace gouge
