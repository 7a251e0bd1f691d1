#include "lib/certify/any_turn.h"

#include <memory>
#include <vector>

#include "lib/base/best_first_search.h"
#include "lib/base/tolerance.h"
#include "lib/certify/check.h"
#include "lib/check/check_move.h"
#include "lib/head/check_heads.h"
#include "lib/motion/motion_law.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerChunk = 256;
constexpr std::uint64_t kBoxes = 12;  // the law of the control decides where more are needed

/// Counts of one chunk of moves.
class AnyTurnCounter {
 public:
  AnyTurnCounter(const Toolpath& path, const CheckSetup& setup, const MotionLaw& law, const HeadChecker* heads,
                 const CheckResult& result)
      : path_(path), setup_(setup), law_(law), heads_(heads), result_(result), options_(setup.options) {
    options_.law = law;
    options_.near_miss_mm = 0;
    options_.gouge_gap_mm = kAnyGap_mm;
    options_.turn_boxes = kBoxes;
  }

  [[nodiscard]] AnyTurnCounts count(std::size_t first, std::size_t last) const {
    AnyTurnCounts counts;
    Group group;
    for (std::size_t i = first; i < last; ++i) {
      if (!is_asked(i)) continue;
      Motion motion = law_.of(path_, i);
      if (!motion.is_defined() || !motion.is_any() || !turns(motion)) continue;
      const bool is_rapid = runs_rapid(path_.moves[i]);
      const ToolVariants& tool = *setup_.tools[path_.moves[i].tool];
      const ToolVariants* const bodies = is_rapid ? &tool : tool.tilted ? tool.tilted->without_cutter() : nullptr;
      if (!is_rapid && bodies == nullptr && heads_ == nullptr) continue;
      if (!group.motions.empty() && group.bodies != bodies) examine(group, counts);
      group.bodies = bodies;
      group.motions.push_back(std::move(motion));
      group.kinds.push_back(run_kind(path_.moves[i]));
    }
    examine(group, counts);
    return counts;
  }

 private:
  /// Motions of the same bodies; none: only heads are examined.
  struct Group {
    const ToolVariants* bodies = nullptr;
    std::vector<Motion> motions;
    std::vector<MoveKind> kinds;
  };

  [[nodiscard]] bool is_asked(std::size_t i) const {
    const MoveState state = result_.verdicts[i].state;
    const Move& move = path_.moves[i];
    const bool is_clean = state == MoveState::clean || state == MoveState::near_miss;
    return is_clean && move.has_start && !move.is_covered() && law_.is_by_axes(move);
  }

  static bool turns(const Motion& motion) {
    return motion.axis_path()->spread({0, 0}, {1, 1}).frame_rad > Tolerance::kSameDirection;
  }

  void examine(Group& group, AnyTurnCounts& counts) const {
    std::vector<MoveVerdict> verdicts(group.motions.size());
    std::vector<std::uint64_t> bounds(group.motions.size(), 0);
    if (group.bodies != nullptr)
      check_moves(group.motions, group.kinds, *group.bodies, setup_.scene, options_, verdicts, bounds);
    for (std::size_t k = 0; k < group.motions.size(); ++k) {
      if (heads_ != nullptr && verdicts[k].state == MoveState::clean)
        heads_->check(group.motions[k], options_, verdicts[k]);
      const bool is_proved = verdicts[k].state == MoveState::clean;
      const bool is_rapid = group.kinds[k] == MoveKind::rapid;
      ++(is_rapid ? counts.rapids : counts.others);
      if (is_proved) ++(is_rapid ? counts.proved_rapids : counts.proved_others);
    }
    group = {};
  }

  const Toolpath& path_;
  const CheckSetup& setup_;
  const MotionLaw& law_;
  const HeadChecker* heads_;
  const CheckResult& result_;
  CheckOptions options_;
};

}  // namespace

std::optional<AnyTurnCounts> count_any_turns(const Toolpath& path, const CheckSetup& setup, const CheckResult& result,
                                             const ProgressCall& progress) {
  const std::optional<MotionLaw> law = setup.options.law.widest();
  if (!law || !setup.scene.is_within_reach) return std::nullopt;
  const std::unique_ptr<const HeadChecker> heads =
      setup.heads.empty() ? nullptr : std::make_unique<const HeadChecker>(setup.heads, setup.scene);
  const AnyTurnCounter counter(path, setup, *law, heads.get(), result);
  std::vector<AnyTurnCounts> parts((path.moves.size() + kMovesPerChunk - 1) / kMovesPerChunk);
  for_each_chunk(
      path.moves.size(), kMovesPerChunk, setup.options.threads, "checking any motion of the joints", progress,
      [&](std::size_t first, std::size_t last) { parts[first / kMovesPerChunk] = counter.count(first, last); });
  AnyTurnCounts sum;
  for (const AnyTurnCounts& part : parts) {
    sum.rapids += part.rapids;
    sum.proved_rapids += part.proved_rapids;
    sum.others += part.others;
    sum.proved_others += part.proved_others;
  }
  return sum.rapids + sum.others > 0 ? std::optional(sum) : std::nullopt;
}

}  // namespace gouge
