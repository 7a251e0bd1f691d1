#include "lib/check/check_path.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/check/buried.h"
#include "lib/check/check_move.h"
#include "lib/check/reach.h"
#include "lib/check/verdict_bytes.h"
#include "lib/motion/motion_law.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

// Number of moves that share bounds. It is fixed, so that the result does not depend on the number of threads.
constexpr std::size_t kMovesPerChunk = 256;

class PathChecker {
 public:
  PathChecker(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
              const CheckOptions& options)
      : toolpath_(toolpath), tools_(tools), scene_(scene), options_(options) {}

  /// Checks the moves [first, last), and returns the number of bounds. Neighbouring moves of one tool are checked
  /// together.
  [[nodiscard]] std::uint64_t check(std::size_t first, std::size_t last, MoveVerdicts& verdicts) const {
    std::uint64_t bounds = 0;
    Batch batch;
    batch.moves.reserve(last - first);
    batch.motions.reserve(last - first);
    batch.kinds.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) {
      const Move& move = toolpath_.moves[i];
      if (!batch.moves.empty() && !has_same_tool(batch.moves.back(), i)) bounds += check(batch, verdicts);
      if (Reason reason = why_not(i); !reason.is(Reason::Kind::none)) {
        verdicts[i] = not_checked(std::move(reason));
        continue;
      }
      Motion motion = options_.law.of(toolpath_, i);
      Reason::Kind unfit = why_unfit(motion);
      if (unfit == Reason::Kind::none && !motion.is_defined()) unfit = Reason::Kind::axis_reversed;
      if (unfit != Reason::Kind::none) {
        verdicts[i] = not_checked({unfit});
        continue;
      }
      batch.moves.push_back(i);
      batch.motions.push_back(std::move(motion));
      batch.kinds.push_back(run_kind(move));
    }
    return bounds + check(batch, verdicts);
  }

 private:
  /// Moves with one tool, in path order.
  struct Batch {
    std::vector<std::size_t> moves;
    std::vector<Motion> motions;
    std::vector<MoveKind> kinds;
  };

  [[nodiscard]] Reason why_not(std::size_t index) const {
    using enum Reason::Kind;
    const Move& move = toolpath_.moves[index];
    const auto of_file = [&] { return Reason{of_path, Body::cutter, 0, std::string(move.not_checked_reason)}; };
    if (!move.not_checked_reason.empty() && !move.is_covered()) return of_file();
    if (move.tool == kNone) return {no_tool};
    if (move.tool >= tools_.size() || tools_[move.tool] == nullptr) return {tool_undefined};
    if (move.needs_wide_tool() && tools_[move.tool]->wide == nullptr) return of_file();
    if (index == 0 && move.has_start) return {no_start};
    if (!has_its_curve(move)) return {no_curve};
    const bool may_be_feed = move.kind == MoveKind::feed && runs_rapid(move);
    if (may_be_feed && options_.law.has_other_rapid(toolpath_, index)) return {rapid_unsure};
    return {move.kind == MoveKind::rapid && options_.law.rapid() == RapidMode::skip ? rapid_skipped : none};
  }

  [[nodiscard]] bool has_same_tool(std::size_t a, std::size_t b) const {
    const Move &first = toolpath_.moves[a], &second = toolpath_.moves[b];
    return first.tool == second.tool && first.needs_wide_tool() == second.needs_wide_tool();
  }

  // Returns the tool form of a move. Requires why_not(index) to be none.
  [[nodiscard]] const ToolVariants& tool_of(std::size_t index) const {
    const Move& move = toolpath_.moves[index];
    const ToolVariants& tool = *tools_[move.tool];
    return move.needs_wide_tool() ? *tool.wide : tool;
  }

  [[nodiscard]] bool has_its_curve(const Move& move) const {
    if (move.curve_kind == CurveKind::arc) return move.curve < toolpath_.arcs.size();
    return move.curve_kind == CurveKind::none || move.curve < toolpath_.splines.size();
  }

  /// Checks and empties the batch, and returns the number of bounds.
  [[nodiscard]] std::uint64_t check(Batch& batch, MoveVerdicts& verdicts) const {
    if (batch.moves.empty()) return 0;
    const std::size_t count = batch.moves.size();
    std::vector<MoveVerdict> found(count);
    std::vector<std::uint64_t> spent(count, 0);
    const ToolVariants& tool = tool_of(batch.moves.front());
    check_moves(batch.motions, batch.kinds, tool, scene_, options_, found, spent);
    for (std::size_t k = 0; k < count; ++k) {
      tighten(batch.motions[k], batch.kinds[k], tool, found[k], spent[k]);
      check_link(batch.moves[k], tool, found[k], spent[k]);
      verdicts[batch.moves[k]] = std::move(found[k]);
    }
    batch.moves.clear();
    batch.motions.clear();
    batch.kinds.clear();
    return std::accumulate(spent.begin(), spent.end(), std::uint64_t{0});
  }

  void check_link(std::size_t index, const ToolVariants& tool, MoveVerdict& verdict, std::uint64_t& spent) const {
    const std::optional<Motion> link = options_.law.link_of(toolpath_, index);
    if (!link || (verdict.state != MoveState::clean && verdict.state != MoveState::near_miss)) return;
    CheckOptions options = options_;
    options.near_miss_mm = 0;
    const bool is_clean = link->is_defined() &&
                          check_move(*link, MoveKind::rapid, tool, scene_, options, &spent).state == MoveState::clean;
    if (!is_clean) verdict = not_checked(link_reason(toolpath_, index));
  }

  // If the tolerance lets the surface come far into the tool, the test for "buried" needs a smaller upper bound.
  // Computes it for this move.
  void tighten(const Motion& motion, MoveKind kind, const ToolVariants& tool, MoveVerdict& verdict,
               std::uint64_t& spent) const {
    const double core = tool.bare.core_depth_mm;
    if (verdict.state != MoveState::clean || !(core > 0) || 2 * verdict.depth_upper_mm < core) return;
    CheckOptions finer = options_;
    finer.tolerance_mm = std::min(finer.tolerance_mm, core / 4);
    finer.resolution_mm = std::min(finer.resolution_mm, core / 8);
    finer.near_miss_mm = 0;
    finer.is_depth_alone = true;
    const MoveVerdict found = check_move(motion, kind, tool, scene_, finer, &spent);
    if (found.state == MoveState::clean)
      verdict.depth_upper_mm = std::min(verdict.depth_upper_mm, found.depth_upper_mm);
  }

  const Toolpath& toolpath_;
  const std::vector<const ToolVariants*>& tools_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
};

// Returns the stored form of verdicts. The sum of the bounds is stored with the first chunk.
CheckpointForm form_of(const Scene& scene, MoveVerdicts& verdicts, std::vector<std::uint64_t>& bounds) {
  CheckpointForm form;
  form.write = [&](std::size_t first, std::size_t last) {
    std::string bytes;
    std::uint64_t sum = 0;
    for (std::size_t chunk = first / kMovesPerChunk; chunk * kMovesPerChunk < last; ++chunk) sum += bounds[chunk];
    append_bytes(sum, bytes);
    for (std::size_t i = first; i < last; ++i) append_bytes(verdicts[i], bytes);
    return bytes;
  };
  form.read = [&](std::size_t first, std::size_t last, std::string_view bytes) {
    std::uint64_t sum = 0;
    std::vector<MoveVerdict> read(last - first);
    bool is_whole = take_bytes(bytes, sum);
    for (MoveVerdict& verdict : read) is_whole = is_whole && take_bytes(bytes, verdict) && is_of_meshes(verdict, scene);
    if (!is_whole || !bytes.empty()) return false;
    bounds[first / kMovesPerChunk] = sum;
    std::move(read.begin(), read.end(), verdicts.begin() + static_cast<std::ptrdiff_t>(first));
    return true;
  };
  return form;
}

}  // namespace

Reason link_reason(const Toolpath& toolpath, std::size_t index) {
  return {Reason::Kind::link_gouges, Body::cutter, static_cast<double>(std::size_t{toolpath.moves[index - 1].line})};
}

CheckResult check_path(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                       const PreparedScene& scene, const CheckOptions& options, const ProgressCall& progress,
                       CheckpointStore* kept) {
  CheckResult result;
  const std::size_t total = toolpath.moves.size();
  result.verdicts.resize(total);
  const PathChecker checker(toolpath, tools, scene, options);
  std::vector<std::uint64_t> bounds((total + kMovesPerChunk - 1) / kMovesPerChunk, 0);
  for_each_checkpointed_chunk(total, kMovesPerChunk, options.threads, "checking moves", progress, kept,
                              form_of(*scene.scene, result.verdicts, bounds), [&](std::size_t first, std::size_t last) {
                                bounds[first / kMovesPerChunk] = checker.check(first, last, result.verdicts);
                              });
  if (scene.is_within_reach && why_unfit(options) == Reason::Kind::none)
    mark_buried(toolpath, tools, scene, options, result.verdicts);
  result.evaluations = std::accumulate(bounds.begin(), bounds.end(), std::uint64_t{0});
  return result;
}

}  // namespace gouge
