#include "postproc/report/report_model.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/sha256.h"
#include "lib/base/tolerance.h"
#include "lib/check/stock_bounds.h"
#include "postproc/record/words.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "postproc/report/tightness.h"

namespace gouge {

InputFile describe_input(std::string role, std::string name, std::string_view bytes) {
  return {std::move(role), std::move(name), bytes.size(), "sha256:" + sha256_of(bytes)};
}

namespace {

// Returns whether moves could not be checked or certified, except rapids excluded on request.
bool has_open_moves(const StateCounts& n) { return n.not_checked > n.skipped || n.not_certified > 0; }

// Returns the fixtures from which a distance must be kept.
std::string clearances_text(const ReportModel& model) {
  std::string text;
  for (const MeshFacts& mesh : model.fixtures) {
    if (!(mesh.clearance_mm > 0)) continue;
    text += ", and no approach to " + mesh.name + " below its clearance of " +
            length_text(mesh.clearance_mm, model.toolpath->unit) + " by more than its own tolerance + resolution";
  }
  return text;
}

// Returns the number of warnings in the notes if --warnings-as-errors is in force, else 0.
std::size_t warnings_as_errors(const ReportModel& model) {
  if (std::ranges::find(model.more_options, "warnings-as-errors", &OptionText::name) == model.more_options.end())
    return 0;
  return static_cast<std::size_t>(std::ranges::count(model.notes, Severity::warning, &Diagnostic::severity));
}

}  // namespace

namespace {

bool has_material_left(const CheckResult& result) { return result.excess && result.excess->proved() > 0; }

bool is_open(const CheckResult& result) {
  return has_open_moves(result.counts) || has_open(result.assumptions) ||
         (result.excess && result.excess->proved() < result.excess->places.size());
}

}  // namespace

OverallVerdict overall_verdict(const CheckResult& result) {
  if (result.counts.gouge + result.counts.buried > 0) return OverallVerdict::gouges;
  if (has_material_left(result)) return OverallVerdict::material_left;
  return is_open(result) ? OverallVerdict::not_fully_checked : OverallVerdict::clean;
}

OverallVerdict overall_verdict(const ReportModel& model) {
  const OverallVerdict verdict = overall_verdict(*model.result);
  if (verdict == OverallVerdict::clean && warnings_as_errors(model) > 0) return OverallVerdict::not_fully_checked;
  if (verdict != OverallVerdict::gouges || !model.baseline.is_given()) return verdict;
  for (std::size_t k = 0; k < model.result->events.size(); ++k) {
    const MoveState state = model.result->events[k].state;
    if (state == MoveState::buried) return verdict;
    if (state == MoveState::gouge && !model.baseline.is_accepted(k)) return verdict;
  }
  const StateCounts& n = model.result->counts;
  if (n.buried > 0 || n.gouge != model.baseline.accepted_moves) return verdict;
  if (has_material_left(*model.result)) return OverallVerdict::material_left;
  const bool is_unsettled = is_open(*model.result) || warnings_as_errors(model) > 0;
  return is_unsettled ? OverallVerdict::not_fully_checked : OverallVerdict::accepted_gouges;
}

const char* verdict_name(OverallVerdict verdict) { return verdict_words()[static_cast<std::size_t>(verdict)].c_str(); }

ExitCode exit_status(OverallVerdict verdict) {
  static constexpr std::array<ExitCode, 5> kStatus = {kExitClean, kExitGouges, kExitNotChecked, kExitClean,
                                                      kExitGouges};
  return kStatus[static_cast<std::size_t>(verdict)];
}

namespace {

/// Describes the motions beside the nominal one that a check covers; empty where there are none.
std::string tube_text(const MotionTube& tube, LengthUnit unit) {
  if (tube.is_empty()) return {};
  const std::string tip = tube.tip_mm > 0 ? length_text(tube.tip_mm, unit) + " at the tip" : "";
  const std::string axis = tube.axis_rad > 0 ? angle_text(tube.axis_rad, DegreeSign::word) + " of the tool axis" : "";
  return ", also where the control departs from its law by up to " + tip +
         (tip.empty() || axis.empty() ? "" : " and ") + axis;
}

}  // namespace

Guarantee guarantee_of(const ReportModel& model) {
  const LengthUnit unit = model.toolpath->unit;
  const CheckOptions& options = model.options;
  const double limit_mm = options.tolerance_mm + options.resolution_mm;
  const std::string limit = "no gouge deeper than tolerance + resolution = " + length_text(limit_mm, unit) +
                            " is missed" + tube_text(options.tube, unit) + clearances_text(model) +
                            ", and where none is reported the tool reaches at most 3 times that into a solid";
  const StateCounts& n = model.result->counts;
  const std::size_t left_out = n.not_checked + n.not_certified;
  const std::size_t covered = model.result->verdicts.size() - left_out;
  const std::string facts = assumptions_text(model.result->assumptions);
  if (left_out == 0) return {limit, facts};
  const std::string not_covered = count_text(left_out, "move") + " not checked or not certified";
  if (covered == 0) return {"none: it does not cover the " + not_covered, ""};
  return {"in the " + count_text(covered, "move") + " that " + (covered == 1 ? "is" : "are") + " certified, " + limit +
              "; it does not cover the " + not_covered,
          facts};
}

std::string guarantee_text(const ReportModel& model) {
  const Guarantee guarantee = guarantee_of(model);
  return guarantee.text + (guarantee.facts.empty() ? "" : "; it rests on " + guarantee.facts);
}

std::vector<std::string> open_facts(const ReportModel& model) {
  std::vector<std::string> all;
  for (const Assumption& fact : model.result->assumptions) {
    if (!fact.is_open) continue;
    const std::string object = fact.object.empty() ? "" : " " + fact.object;
    all.push_back(std::string(subject_name(fact.subject)) + object + " (" + basis_name(fact.basis) +
                  "): " + fact.evidence + "; " + fact.remedy);
  }
  if (const std::size_t warnings = warnings_as_errors(model); warnings > 0)
    all.push_back("no warning (contradicted): the result has " + count_text(warnings, "warning") +
                  "; settle them, or leave out --warnings-as-errors");
  return all;
}

namespace {

// States how many gouges of the part may come from its facets: without their estimated error they are within tolerance.
std::string chord_error_text(const ReportModel& model) {
  std::size_t gouges = 0, within = 0;
  double most_mm = 0;
  for (std::size_t i = 0; i < model.chord_errors_mm.size(); ++i) {
    const Event& event = model.result->events[i];
    if (event.state != MoveState::gouge || event.against != Against::part) continue;
    ++gouges;
    const double error_mm = model.chord_errors_mm[i];
    if (model.result->verdicts[event.worst_move].depth_mm > model.options.tolerance_mm + error_mm) continue;
    ++within;
    most_mm = std::max(most_mm, error_mm);
  }
  if (within == 0) return {};
  const LengthUnit unit = model.toolpath->unit;
  return std::to_string(within) + " of " + count_text(gouges, "finding") +
         " in the part may come from the facets of the STL alone: "
         "its chord error there is about " +
         depth_text(most_mm, unit) + (within > 1 ? " at most" : "") +
         "; export it with a chordal tolerance well below " + length_text(model.options.tolerance_mm, unit);
}

// So few cuts do not contradict the placement, but the user should look at it.
std::string few_cuts_apart_text(const ReportModel& model) {
  const std::optional<ClosestApproach>& approach = model.result->closest_approach;
  const bool is_stated = std::ranges::any_of(model.result->assumptions, [](const Assumption& fact) {
    return fact.subject == Subject::placement && fact.basis != Basis::by_default;
  });
  if (!approach || is_stated || !approach->is_apart()) return {};
  return apart_text(*approach) + "; check units and --place";
}

}  // namespace

std::vector<std::string> reservations(const ReportModel& model) {
  constexpr std::size_t kNamed = 5;
  std::vector<std::string> all = remedies(model);
  for (const Diagnostic& note : model.notes) {
    if (note.code == kProjectFile || note.code == kLengthsInMm || note.code == kOptionUnused)
      all.push_back(note.message);
  }
  // "Clean" is the verdict on the remaining path; the part may have uncut material.
  if (std::string uncut = uncut_text(model.correction, model.toolpath->unit); !uncut.empty())
    all.push_back(std::move(uncut));
  if (std::string moved = moved_cuts_text(model.correction, model.toolpath->unit); !moved.empty())
    all.push_back(std::move(moved));
  if (const std::string stock = stock_text(model.correction, model.toolpath->unit); !stock.empty())
    all.push_back("stock: " + stock);
  if (std::string low = low_rapids_text(model.correction, model.toolpath->unit); !low.empty())
    all.push_back(std::move(low));
  if (std::string gaps = depth_gaps_text(model); !gaps.empty()) all.push_back(std::move(gaps));
  if (std::string chords = chord_error_text(model); !chords.empty()) all.push_back(std::move(chords));
  if (std::string apart = few_cuts_apart_text(model); !apart.empty()) all.push_back(std::move(apart));
  std::vector<std::string> bare;  // several tools may have one number
  for (const ToolFacts& tool : model.tools) {
    const std::string name = tool.name.empty() ? "the unnamed tool" : tool.name;
    if (!tool.has_holder && std::ranges::find(bare, name) == bare.end()) bare.push_back(name);
  }
  std::string named;
  for (std::size_t k = 0; k < std::min(bare.size(), kNamed); ++k) named += (k == 0 ? "" : ", ") + bare[k];
  if (bare.size() > kNamed) named += " and " + std::to_string(bare.size() - kNamed) + " more";
  if (!bare.empty()) all.push_back(named + (bare.size() > 1 ? " have" : " has") + " no holder, so none is checked");
  return all;
}

std::string closest_approach_words(const std::optional<double>& distance_mm, LengthUnit unit) {
  constexpr double kTouch_mm = 0.01;
  if (!distance_mm) return "not within " + length_text(ClosestApproach::kFar_mm, unit);
  if (*distance_mm <= kTouch_mm) return "touching";
  // The distance is rounded up, so that "within" is true.
  const int decimals = facts_of(unit).decimals - 1;
  const double steps = std::pow(10, decimals);
  const double reported = std::ceil(*distance_mm / mm_per(unit) * steps - Tolerance::kWitness_mm) / steps;
  return "within " + fixed_text(reported, decimals) + " " + unit_name(unit);
}

std::string law_label(const LawRecord& law) { return (law.is_rapid ? "rapids by " : "feeds by ") + law.law; }

std::string law_text(const ReportModel& model, const LawRecord& law) {
  if (!law.missing.empty()) return "not checked, " + law.missing;
  std::string text = law.gouges == 0 ? "no gouge" : count_text(law.gouges, "move") + " with a gouge, the deepest ";
  if (law.depth_mm) text += length_text(*law.depth_mm, model.toolpath->unit);
  if (law.line) text += " at line " + std::to_string(*law.line);
  if (law.open > 0) text += ", " + count_text(law.open, "move") + " not checked or not certified";
  return text;
}

std::string any_turn_text(const ReportModel& model) {
  const std::optional<AnyTurnCounts>& counts = model.result->any_turn;
  if (!counts) return {};
  const auto share = [](std::size_t proved, std::size_t all) {
    return std::to_string(proved) + " of " + std::to_string(all) + " ";
  };
  const auto moves = [](std::size_t count, const char* one, const char* many) {
    return std::string(count == 1 ? one : many);
  };
  const bool has_rapids = counts->rapids > 0, has_others = counts->others > 0;
  std::string text;
  if (has_rapids)
    text += share(counts->proved_rapids, counts->rapids) + moves(counts->rapids, "rapid", "rapids") +
            (counts->rapids == 1 ? " that turns them is clean" : " that turn them are clean");
  if (has_rapids && has_others) text += ", and ";
  if (has_others)
    text += share(counts->proved_others, counts->others) +
            moves(counts->others, has_rapids ? "other move" : "move", has_rapids ? "other moves" : "moves") +
            (counts->others == 1 ? " is clean apart from the cutter" : " are clean apart from the cutter");
  return text + ", whatever the control does with the rotary joints between two positions";
}

std::string stock_text(const ReportModel& model) {
  if (!model.result->stock) return {};
  const StockFacts& facts = *model.result->stock;
  const LengthUnit unit = model.toolpath->unit;
  return std::to_string(facts.clear) + " of " + count_text(facts.examined, "move") +
         " examined are clear of remaining stock to " +
         length_text(largest_clear_stock_mm(facts.tolerance_mm, facts.resolution_mm), unit) +
         "; material thinner than " + length_text(2 * facts.resolution_mm, unit) +
         " counts as removed, and pieces that are cut free stay where they are";
}

std::string stock_left_text(const ReportModel& model) {
  if (!model.stock_left) return {};
  const StockLeft& left = *model.stock_left;
  if (left.perhaps_file.empty()) return "nothing is left of the stock; no mesh is written";
  const auto volume = [](double mm3) { return display_text(mm3, 0) + " mm3"; };
  if (left.surely_file.empty())
    return "at most " + volume(left.perhaps_mm3) + " are left; nothing is surely left, so only one mesh is written";
  return "between " + volume(left.surely_mm3) + " and " + volume(left.perhaps_mm3) +
         " are left; between both meshes are at most " + length_text(left.apart_mm.value_or(0), model.toolpath->unit);
}

std::string closest_approach_text(const ReportModel& model) {
  if (!model.result->closest_approach) return {};
  const ClosestApproach& c = *model.result->closest_approach;
  const LengthUnit unit = model.toolpath->unit;
  if (c.positions == 1) return closest_approach_words(c.nearest_mm, unit) + " along the path";
  return closest_approach_words(c.nearest_mm, unit) + "; half of the " + positions_examined(c) + " are " +
         closest_approach_words(c.median_mm, unit);
}

std::vector<ReasonGroup> group_reasons(const CheckResult& result) {
  std::vector<ReasonGroup> groups;
  std::map<std::pair<MoveState, std::string>, std::size_t> known;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const MoveVerdict& verdict = result.verdicts[i];
    if (verdict.state != MoveState::not_checked && verdict.state != MoveState::not_certified) continue;
    const std::string reason = reason_text(verdict.reason);
    const auto [entry, is_new] = known.try_emplace({verdict.state, reason}, groups.size());
    if (is_new) groups.push_back({verdict.state, reason, 0, i});
    ++groups[entry->second].moves;
  }
  return groups;
}

}  // namespace gouge
