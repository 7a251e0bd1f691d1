#include "lib/check/closeness.h"

#include <algorithm>
#include <limits>

#include "lib/base/parallel.h"
#include "lib/check/sweep_filter.h"

namespace gouge {
namespace {

constexpr std::size_t kMostPositions = 400;
constexpr std::size_t kPositionsPerChunk = 16;
constexpr double kAccuracy_mm = 0.01;
constexpr std::uint64_t kBudget = 20'000;

bool is_cut(const Move& move, const std::vector<const ToolForms*>& tools) {
  return move.kind != MoveKind::rapid && move.not_checked_reason.empty() && move.tool < tools.size() &&
         tools[move.tool] != nullptr && move.end.tip.cwiseAbs().maxCoeff() <= kFarthest_mm;
}

// Of `count` cuts those in the middle of equal shares.
std::vector<std::size_t> spread(const Toolpath& toolpath, const std::vector<const ToolForms*>& tools,
                                std::size_t count) {
  const std::size_t wanted = std::min(count, kMostPositions);
  std::vector<std::size_t> chosen;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < toolpath.moves.size() && chosen.size() < wanted; ++i) {
    if (!is_cut(toolpath.moves[i], tools)) continue;
    if (seen++ == (2 * chosen.size() + 1) * count / (2 * wanted)) chosen.push_back(i);
  }
  return chosen;
}

double distance_mm(const Pose& pose, const ToolForms& tool, const PreparedScene& scene) {
  const SearchTarget part{&tool.against_part, &scene.parts, Against::part};
  const SearchAnswer answer =
      sweep_and_search(Motion(pose), {part}, {Closeness::kFar_mm, 0, kAccuracy_mm, kAccuracy_mm, kBudget});
  if (!answer.has_witness) return std::numeric_limits<double>::infinity();
  return std::max(0.0, Closeness::kFar_mm - answer.value_mm);
}

std::optional<double> if_near(double distance) {
  return distance <= Closeness::kFar_mm ? std::optional(distance) : std::nullopt;
}

}  // namespace

std::optional<Closeness> measure_closeness(const Toolpath& toolpath, const std::vector<const ToolForms*>& tools,
                                           const PreparedScene& scene, unsigned threads) {
  Closeness closeness;
  closeness.cuts = static_cast<std::size_t>(std::count_if(
      toolpath.moves.begin(), toolpath.moves.end(), [&](const Move& move) { return is_cut(move, tools); }));
  if (closeness.cuts == 0 || scene.parts.nodes.empty() || !scene.is_within_reach) return std::nullopt;
  const std::vector<std::size_t> chosen = spread(toolpath, tools, closeness.cuts);
  std::vector<double> distances(chosen.size());
  for_each_chunk(chosen.size(), kPositionsPerChunk, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Move& move = toolpath.moves[chosen[k]];
      distances[k] = distance_mm(move.end, *tools[move.tool], scene);
    }
  });
  std::sort(distances.begin(), distances.end());
  closeness.positions = distances.size();
  closeness.nearest_mm = if_near(distances.front());
  closeness.median_mm = if_near(distances[(distances.size() - 1) / 2]);
  return closeness;
}

}  // namespace gouge
