#include "lib/cure/find_cures.h"

#include <algorithm>

#include "lib/certify/motion_checker.h"
#include "lib/correct/tilt_path.h"

namespace gouge {
namespace {

constexpr const char* kBuried = "it is inside a solid: from there no tilt is sought";
constexpr const char* kNoRun = "it lies in no run that can be tilted: tilts are of straight moves and curves at feed";
constexpr const char* kNotProved = "the check of the tilted path does not find it free";

bool is_free(const MoveVerdict& verdict) {
  return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
}

Body body_of(const MoveVerdict& verdict) { return verdict.witness ? verdict.witness->body : verdict.reason.body; }

/// Cures are sought among parts and fixtures; `correct --stock` finds ways out of stock.
bool is_curable(const Event& event) {
  return event.body != Body::cutter && event.against != Against::stock &&
         (event.state == MoveState::gouge || event.state == MoveState::buried);
}

/// Returns the moves that an event counts.
std::vector<std::size_t> moves_of(const Event& event, const Toolpath& path, const CheckResult& result) {
  std::vector<std::size_t> moves;
  for (std::size_t i = event.first_move; i <= event.last_move; ++i) {
    const MoveVerdict& verdict = result.verdicts[i];
    if (verdict.state == event.state && path.moves[i].tool == event.tool && body_of(verdict) == event.body)
      moves.push_back(i);
  }
  return moves;
}

/// All tilts of a path, and the result of check() with them.
class TiltCures {
 public:
  TiltCures(const Toolpath& path, const CheckResult& result, const CheckSetup& setup, const CureOptions& options,
            const ProgressCall& progress)
      : setup_(setup), checker_(setup) {
    const BodyStrategies strategies;
    proposal_ = propose_tilts({path, result, setup_.tools, checker_, strategies, options.tilt}, progress);
    if (proposal_.plan.runs.empty()) return;
    tilted_ = tilt_path(path, result, proposal_.straight, proposal_.plan, setup_.tools, checker_);
    after_ = check(tilted_->path, setup_, progress);
  }

  /// Returns the tilt for some moves, given as indices in the path before.
  [[nodiscard]] TiltCure of(const std::vector<std::size_t>& moves) const {
    const auto [first, last] = std::pair(moves.front(), moves.back());
    for (const UntiltedRun& run : proposal_.plan.failed) {
      if (proposal_.origin_of(run.first_wanted) <= last && proposal_.origin_of(run.last_wanted) >= first)
        return {std::nullopt, run.reason};
    }
    TiltCure cure;
    for (const SmoothedRun& run : proposal_.plan.runs) {
      if (proposal_.origin_of(run.first_wanted) > last || proposal_.origin_of(run.last_wanted) < first) continue;
      if (run.positions.empty()) continue;
      if (!is_proved(run)) return {std::nullopt, kNotProved};
      for (const TiltedPosition& p : run.positions) cure.tilt_rad = std::max(cure.tilt_rad.value_or(0), p.tilt_rad);
    }
    if (!cure.tilt_rad) return {std::nullopt, kNoRun};
    const bool is_free_now = std::ranges::all_of(moves, [this](std::size_t i) { return is_free_after(i, i); });
    return is_free_now ? cure : TiltCure{std::nullopt, kNotProved};
  }

 private:
  /// Returns whether check() finds everything free that replaced the moves [first, last].
  [[nodiscard]] bool is_free_after(std::size_t first, std::size_t last) const {
    const std::vector<std::size_t>& origin = tilted_->origin;
    for (auto piece = std::ranges::lower_bound(origin, first); piece != origin.end() && *piece <= last; ++piece) {
      if (!is_free(after_.verdicts[static_cast<std::size_t>(piece - origin.begin())])) return false;
    }
    return true;
  }

  /// Returns whether every motion that the run changed is proved free, including the motion after its last position.
  [[nodiscard]] bool is_proved(const SmoothedRun& run) const {
    const std::size_t first = proposal_.origin_of(run.positions.front().move);
    const std::size_t last = proposal_.origin_of(run.positions.back().move) + (run.positions.back().is_end ? 1 : 0);
    const std::vector<std::size_t>& origin = tilted_->origin;
    for (auto piece = std::ranges::lower_bound(origin, first); piece != origin.end() && *piece <= last; ++piece) {
      const auto i = static_cast<std::size_t>(piece - origin.begin());
      if (tilted_->is_moved[i] && !is_free(after_.verdicts[i])) return false;
    }
    return true;
  }

  const CheckSetup& setup_;
  MotionChecker checker_;
  TiltProposal proposal_;
  std::optional<ReworkedPath> tilted_;  // none: there is no run
  CheckResult after_;
};

}  // namespace

std::vector<FindingCures> find_cures(const Toolpath& path, const CheckResult& result, const CheckSetup& setup,
                                     const CureOptions& options, const ProgressCall& progress) {
  std::vector<FindingCures> cures;
  if (std::ranges::none_of(result.events, is_curable)) return cures;
  const TiltCures tilts(path, result, setup, options, progress);
  for (std::size_t k = 0; k < result.events.size(); ++k) {
    const Event& event = result.events[k];
    if (progress) progress("looking for cures", k, result.events.size());
    if (!is_curable(event)) continue;
    const std::vector<std::size_t> moves = moves_of(event, path, result);
    FindingCures one;
    one.event = k;
    one.tilt = event.state == MoveState::buried ? TiltCure{std::nullopt, kBuried} : tilts.of(moves);
    one.lift = find_lift(path, moves, setup, options.lift_step_mm, options.max_lift_mm);
    cures.push_back(std::move(one));
  }
  return cures;
}

}  // namespace gouge
