#include "lib/check/closest_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/number_text.h"
#include "lib/base/parallel.h"
#include "lib/check/reach.h"
#include "lib/check/sweep_filter.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxPositions = 400;
constexpr std::size_t kPositionsPerChunk = 16;
constexpr double kAccuracy_mm = 0.01;
constexpr std::uint64_t kApproachBudget = 20'000;

bool is_cut(const Move& move, const std::vector<const ToolVariants*>& tools) {
  return move.kind != MoveKind::rapid && move.not_checked_reason.empty() && move.tool < tools.size() &&
         tools[move.tool] != nullptr && why_unfit(move.end) == Reason::Kind::none;
}

std::uint64_t mixed(std::uint64_t k) {
  k = (k ^ (k >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  k = (k ^ (k >> 27U)) * 0x94d049bb133111ebULL;
  return k ^ (k >> 31U);
}

// Divides the cuts into equal shares and picks one cut of each share by a hash. Paths repeat a pattern many times, and
// equal steps would always pick the same point of it.
std::vector<std::size_t> spread(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                                std::size_t count) {
  const std::size_t wanted = std::min(count, kMaxPositions);
  std::vector<std::size_t> chosen;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < toolpath.moves.size() && chosen.size() < wanted; ++i) {
    if (!is_cut(toolpath.moves[i], tools)) continue;
    const std::size_t k = chosen.size();
    const std::size_t first = k * count / wanted, last = (k + 1) * count / wanted;
    if (seen++ == first + mixed(k + 1) % (last - first)) chosen.push_back(i);
  }
  return chosen;
}

struct Distance {
  double seen_mm = 0;  ///< distance of a surface point that was found; infinite if none was found
  double min_mm = 0;   ///< proved lower bound
};

Distance distance_from_part(const Motion& motion, const ToolVariants& tool, const PreparedScene& scene) {
  const SearchTarget part = target_on(tool.*scene.workpiece().rule.form, scene.workpiece());
  const SearchResult result =
      sweep_and_search(motion, {part}, {{0, kAccuracy_mm, kAccuracy_mm, kApproachBudget}, ClosestApproach::kFar_mm});
  const double seen =
      result.has_witness ? ClosestApproach::kFar_mm - result.value_mm : std::numeric_limits<double>::infinity();
  return {std::max(0.0, seen), std::max(0.0, ClosestApproach::kFar_mm - result.value_upper_mm)};
}

// Returns the smallest distance of a part in cuts that the verdicts of the check contain: 0 if a surface point is in
// the tool.
double seen_by_check_mm(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                        const MoveVerdicts& verdicts) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < toolpath.moves.size() && i < verdicts.size(); ++i) {
    const MoveVerdict& v = verdicts[i];
    const bool is_seen = v.witness && rule_of(v.witness->against).is_workpiece && v.witness->body != Body::head;
    if (!is_seen || !is_cut(toolpath.moves[i], tools)) continue;
    if (v.depth_mm > 0) return 0;
    if (v.clearance_mm) nearest = std::min(nearest, *v.clearance_mm);
  }
  return nearest;
}

std::optional<double> if_near(double distance) {
  return distance <= ClosestApproach::kFar_mm ? std::optional(distance) : std::nullopt;
}

// Returns the smallest distance that the tool has along the chosen cuts whose tool axis stays, so that the law of motion
// does not matter. Infinite if there is no such cut.
double nearest_within_cuts_mm(const Toolpath& toolpath, const std::vector<std::size_t>& chosen,
                              const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                              unsigned threads) {
  std::vector<double> nearest_mm(chosen.size(), std::numeric_limits<double>::infinity());
  for_each_chunk(chosen.size(), kPositionsPerChunk, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Move& move = toolpath.moves[chosen[k]];
      if (!move.has_start || toolpath.start_of(chosen[k]).axis != move.end.axis) continue;
      const Motion motion = MotionLaw().of(toolpath, chosen[k]);
      if (motion.is_defined()) nearest_mm[k] = distance_from_part(motion, *tools[move.tool], scene).seen_mm;
    }
  });
  return *std::min_element(nearest_mm.begin(), nearest_mm.end());
}

}  // namespace

std::string positions_examined(const ClosestApproach& closest_approach) {
  const std::string positions = count_text(closest_approach.positions, "cutting position");
  if (closest_approach.positions == closest_approach.cuts) return positions;
  return positions + " examined (of " + std::to_string(closest_approach.cuts) + ")";
}

std::string apart_text(const ClosestApproach& closest_approach) {
  // Distances are rounded down, because they must hold for each position.
  const auto rounded = [](double mm) { return fixed_text(std::floor(mm * 10) / 10, 1); };
  const std::string apart = rounded(closest_approach.apart_mm);
  std::string text = closest_approach.cuts == 1
                         ? "at the only cutting position the tool is not nearer than "
                         : "at none of " + positions_examined(closest_approach) + " is the tool nearer than ";
  text += apart + " mm to the part";
  const double along = closest_approach.nearest_mm.value_or(ClosestApproach::kFar_mm);
  if (along < closest_approach.apart_mm && rounded(along) != apart)
    text += ", and along the path it is not seen nearer than " + rounded(along) + " mm";
  return text;
}

std::optional<ClosestApproach> measure_closest_approach(const Toolpath& toolpath,
                                                        const std::vector<const ToolVariants*>& tools,
                                                        const PreparedScene& scene, const MoveVerdicts& verdicts,
                                                        unsigned threads) {
  ClosestApproach closest_approach;
  closest_approach.cuts = static_cast<std::size_t>(std::count_if(
      toolpath.moves.begin(), toolpath.moves.end(), [&](const Move& move) { return is_cut(move, tools); }));
  if (closest_approach.cuts == 0 || scene.workpiece_tree().nodes.empty() || !scene.is_within_reach) return std::nullopt;
  const std::vector<std::size_t> chosen = spread(toolpath, tools, closest_approach.cuts);
  std::vector<double> distances(chosen.size()), least(chosen.size());
  for_each_chunk(chosen.size(), kPositionsPerChunk, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Move& move = toolpath.moves[chosen[k]];
      const Distance found = distance_from_part(MotionLaw::tool_at(move.end), *tools[move.tool], scene);
      distances[k] = found.seen_mm;
      least[k] = found.min_mm;
    }
  });
  std::sort(distances.begin(), distances.end());
  closest_approach.positions = distances.size();
  closest_approach.apart_mm = *std::min_element(least.begin(), least.end());
  double nearest_mm = std::min(distances.front(), seen_by_check_mm(toolpath, tools, verdicts));
  // A cut may pass over the part from one side to the other, with both ends beside it.
  if (nearest_mm > ClosestApproach::kApart_mm)
    nearest_mm = std::min(nearest_mm, nearest_within_cuts_mm(toolpath, chosen, tools, scene, threads));
  closest_approach.nearest_mm = if_near(nearest_mm);
  closest_approach.median_mm = if_near(distances[(distances.size() - 1) / 2]);
  return closest_approach;
}

}  // namespace gouge
