#include "lib/certify/settle_ways.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/parallel.h"
#include "lib/certify/check.h"
#include "lib/certify/motion_checker.h"
#include "lib/certify/obstructions.h"
#include "lib/motion/motion_law.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr std::size_t kWaysPerChunk = 16;
constexpr double kAbove_mm = 1;  // beyond the box of all meshes, so that rounding leaves no contact

/// A way that the file does not state, from or to the end of a move.
struct Way {
  std::size_t move = 0;
  bool is_departure = false;
};

/// Result of the search for a gouge on a way.
struct WayResult {
  bool is_free = true;
  double depth_mm = 0;  ///< of a proved gouge; 0: there is none
};

std::vector<Way> ways_of(const Toolpath& path) {
  std::vector<Way> ways;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!path.moves[i].begins_stretch) continue;
    if (i > 0) ways.push_back({i - 1, true});
    ways.push_back({i, false});
  }
  if (!ways.empty()) ways.push_back({path.moves.size() - 1, true});
  return ways;
}

class WayChecker {
 public:
  WayChecker(const Toolpath& path, const CheckSetup& setup, const MoveVerdicts& verdicts)
      : path_(path),
        setup_{setup.tools, path.joints ? no_heads_ : setup.heads, setup.scene, setup.options},
        verdicts_(verdicts),
        obstructions_(setup),
        lowest_mm_(lowest_point_mm(setup)),
        checker_(setup_),
        options_(setup.options) {
    options_.near_miss_mm = 0;
    options_.law = MotionLaw();
  }

  [[nodiscard]] WayResult examine(const Way& way) const {
    const Move& move = path_.moves[way.move];
    if (!is_clean(verdicts_[way.move]) || move.tool >= setup_.tools.size() || setup_.tools[move.tool] == nullptr)
      return {};
    const Pose& low = move.end;
    const double rise_mm = obstructions_.top_along(low.axis).height_mm - low.axis.dot(low.tip) - lowest_mm_ + kAbove_mm;
    if (!(rise_mm > kAbove_mm)) return {};
    const Motion motion = options_.law.straight(low, {low.tip + rise_mm * low.axis, low.axis});
    const ToolVariants& stated = *setup_.tools[move.tool];
    const ToolVariants& tool = move.needs_wide_tool() ? *stated.wide : stated;
    MoveVerdict found = checker_.check(motion, run_kind(move), tool, options_, true);
    if (found.reason.is(Reason::Kind::body_too_thin)) found = examine_thin(motion, run_kind(move), tool);
    if (is_clean(found)) return {};
    return {false, found.state == MoveState::gouge ? found.depth_mm : 0};
  }

 private:
  [[nodiscard]] static bool is_clean(const MoveVerdict& verdict) {
    return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
  }

  /// Checks with a depth at which a thin tool cannot pass into a solid.
  [[nodiscard]] MoveVerdict examine_thin(const Motion& motion, MoveKind kind, const ToolVariants& tool) const {
    CheckOptions finer = options_;
    finer.tolerance_mm = std::min(finer.tolerance_mm, tool.bare.core_depth_mm / 4);
    finer.resolution_mm = std::min(finer.resolution_mm, tool.bare.core_depth_mm / 8);
    return checker_.check(motion, kind, tool, finer, true);
  }

  const Toolpath& path_;
  const std::vector<HeadBody> no_heads_;
  const CheckSetup setup_;
  const MoveVerdicts& verdicts_;
  const Obstructions obstructions_;
  const double lowest_mm_;
  const MotionChecker checker_;
  CheckOptions options_;
};

/// Returns the first way that is not proved free; none: all are.
std::optional<std::pair<Way, WayResult>> find_obstructed(const std::vector<Way>& ways, const WayChecker& checker,
                                                         unsigned threads) {
  std::vector<WayResult> results(ways.size());
  for_each_chunk(ways.size(), kWaysPerChunk, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) results[k] = checker.examine(ways[k]);
  });
  const auto found = std::ranges::find(results, false, &WayResult::is_free);
  if (found == results.end()) return std::nullopt;
  return std::pair(ways[static_cast<std::size_t>(found - results.begin())], *found);
}

std::string evidence_of(const Toolpath& path, const Way& way, const WayResult& result) {
  const std::string line = "line " + std::to_string(std::size_t{path.moves[way.move].line});
  const std::string does = way.is_departure ? "leave " + line : "come to " + line;
  std::string text = "it is not proved that the tool can " + does + " along its axis";
  if (result.depth_mm > 0)
    text = "the tool cannot " + does + " along its axis without a gouge of " +
           display_text(result.depth_mm / mm_per(path.unit), 4) + " " + unit_name(path.unit);
  return text + ", and the file does not state how it does";
}

}  // namespace

void settle_ways(const Toolpath& path, const CheckSetup& setup, const MoveVerdicts& verdicts, Assumptions& facts) {
  const auto fact = std::ranges::find(facts, Subject::completeness, &Assumption::subject);
  if (fact == facts.end() || (fact->basis != Basis::derived && fact->basis != Basis::by_default)) return;
  const std::vector<Way> ways = ways_of(path);
  if (ways.empty()) return;
  fact->code = "path-ways";
  fact->basis = Basis::by_default;
  fact->value += " without " + count_text(ways.size(), "way") + " to and from the part";
  fact->evidence =
      "the file states no way to the first position of a tool and from its last one; from each that is clean the way "
      "along the tool axis is free";
  fact->line = path.moves[ways.front().move].line;
  fact->remedy = "state that nothing is in the way there with --assume complete";
  const auto obstructed = find_obstructed(ways, WayChecker(path, setup, verdicts), setup.options.threads);
  if (!obstructed) return;
  fact->basis = Basis::unknown;
  fact->evidence = evidence_of(path, obstructed->first, obstructed->second);
  fact->line = path.moves[obstructed->first.move].line;
  fact->remedy = "add the way to the file, or state that nothing is in the way there with --assume complete";
}

}  // namespace gouge
