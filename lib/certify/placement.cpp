#include "lib/certify/placement.h"

#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/check/scene_reach.h"
#include "lib/hierarchy/closest_triangle.h"

namespace gouge {
namespace {

using SizeTest = std::function<bool(double times)>;

bool any_size(double) { return true; }

// Returns a text about units with which the part would be about as large as the path; empty if there is no such unit.
std::string unit_hint(double times_smaller, LengthUnit unit, const SizeTest& fits) {
  std::string words;
  std::vector<const UnitFacts*> units = units_that_fit(times_smaller, unit);
  std::erase_if(units, [&](const UnitFacts* other) { return !fits(other->mm / mm_per(unit)); });
  for (const UnitFacts* fitting : units)
    words += (words.empty() ? "" : " or ") + std::string("--stl-units ") + std::string(fitting->option);
  return words.empty() ? words : "; with " + words + " it would be about as large as the path";
}

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::floor(100 * share + Tolerance::kRounding))) + " %";
}

std::string percent(std::size_t some, std::size_t all) {
  return percent(all == 0 ? 0.0 : static_cast<double>(some) / static_cast<double>(all));
}

std::string misfit_finding(const PathFit& fit) {
  const std::string positions = std::to_string(fit.positions) + " cutting positions";
  if (fit.kind == PathFit::Kind::too_deep) {
    return percent(fit.deep, fit.positions) + " of the " + positions +
           " are as deep in it as the cutter's radius, or the tool is inside it";
  }
  if (fit.kind == PathFit::Kind::apart) return "the tool hardly touches it where it cuts";
  return percent(fit.gouging, fit.positions) + " of the " + positions + " gouge it by far more than they touch it";
}

struct CutCount {
  std::size_t cuts = 0, deep = 0;
};

CutCount count_cuts(const Toolpath& path, const MoveVerdicts& verdicts) {
  CutCount count;
  for (std::size_t i = 0; i < path.moves.size() && i < verdicts.size(); ++i) {
    if (path.moves[i].kind == MoveKind::rapid) continue;
    ++count.cuts;
    count.deep += verdicts[i].state == MoveState::gouge || verdicts[i].state == MoveState::buried ? 1U : 0U;
  }
  return count;
}

}  // namespace

std::optional<double> nearest_tip_mm(const Toolpath& path, const BlockTree& part, double times) {
  constexpr std::size_t kPositions = 450;
  std::vector<Vec3> tips;
  for (const Move& move : path.moves)
    if (move.kind != MoveKind::rapid) tips.push_back(move.end.tip);
  const std::size_t step = tips.size() / kPositions + 1;
  std::optional<double> nearest_mm;
  for (std::size_t i = 0; i < tips.size(); i += step) {
    const double within_mm = nearest_mm.value_or(std::numeric_limits<double>::infinity()) / times;
    const auto found = closest_triangle(part, tips[i] / times, within_mm);
    if (found) nearest_mm = std::sqrt(found->foot.distance2_mm2) * times;
  }
  return nearest_mm;
}

std::optional<std::string> find_gap(const Toolpath& path, const Scene& scene, const BlockTree& part, double tool_mm) {
  const std::optional<PartsBesidePath> parts = compare_parts(path, scene);
  if (!parts || parts->gap_mm <= tool_mm) return std::nullopt;
  if (const std::optional<double> tip_mm = nearest_tip_mm(path, part))
    return "no move reaches the part; the nearest cutting position examined is " + fixed_text(*tip_mm, 0) + " mm away";
  return "no move comes nearer than " + fixed_text(parts->gap_mm - tool_mm, 0) + " mm to the part";
}

std::optional<std::string> find_other_size(const Toolpath& path, const Scene& scene, const MoveVerdicts& verdicts,
                                           LengthUnit unit) {
  const std::optional<PartsBesidePath> parts = compare_parts(path, scene);
  if (!parts) return std::nullopt;
  const std::string hint = unit_hint(parts->times_smaller, unit, any_size);
  if (parts->is_far_smaller())
    return "the part is " + display_text(parts->times_smaller, 0) + " times smaller than the path" + hint;
  if (!parts->is_far_larger() || hint.empty()) return std::nullopt;
  const CutCount count = count_cuts(path, verdicts);
  if (2 * count.deep <= count.cuts) return std::nullopt;
  return "the part is " + display_text(1 / parts->times_smaller, 0) + " times larger than the path, and " +
         std::to_string(count.deep) + " of " + std::to_string(count.cuts) + " cuts are in it" + hint;
}

std::optional<std::string> explain_by_unit(const Toolpath& path, const Scene& scene, LengthUnit unit, bool is_moved,
                                           const SizeTest& fits) {
  const std::optional<PartsBesidePath> parts = compare_parts(path, scene);
  if (!parts) return std::nullopt;
  const std::string hint = unit_hint(parts->times_smaller, unit, fits);
  const bool is_smaller = parts->is_far_smaller();
  if (!is_smaller && (hint.empty() || !parts->is_far_larger())) {
    auto units = is_moved ? std::vector<const UnitFacts*>() : units_in_place(path, scene, unit);
    std::erase_if(units, [&](const UnitFacts* other) { return !fits(other->mm / mm_per(unit)); });
    if (units.size() != 1) return std::nullopt;
    return "with --stl-units " + std::string(units.front()->option) + " the path would lie in the part";
  }
  return "the part is " + display_text(is_smaller ? parts->times_smaller : 1 / parts->times_smaller, 0) + " times " +
         (is_smaller ? "smaller" : "larger") + " than the path" + hint;
}

std::optional<std::string> find_apart(const ClosestApproach& closest_approach) {
  if (closest_approach.positions < ClosestApproach::kMinPositions || !closest_approach.is_apart()) return std::nullopt;
  return apart_text(closest_approach);
}

std::optional<std::string> describe_misfit(const Toolpath& path, const PathFit& fit) {
  if (fit.kind == PathFit::Kind::fits) return std::nullopt;
  std::string message =
      "the path does not fit the part: " + misfit_finding(fit) + "; check units, placement, axis sign";
  if (!fit.explanation) return message;
  message += ": with " + fit.explanation->text + " " + percent(fit.explanation->share) +
             (fit.explanation->is_of_all ? " of the positions touch the part"
                                         : " of the positions it concerns touch the part");
  return path.has_turned_frame ? message + " (in part coordinates, which the file's frame turns)" : message;
}

bool is_beyond_correction(const PathFit& fit) {
  return fit.kind == PathFit::Kind::too_deep || fit.kind == PathFit::Kind::mistaken;
}

}  // namespace gouge
