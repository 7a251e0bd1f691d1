#include "lib/stickout/find_stickout.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/certify/motion_checker.h"
#include "lib/motion/motion_law.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerChunk = 8;

bool is_free(const MoveVerdict& verdict) {
  return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
}

bool is_hit(const MoveVerdict& verdict) {
  return verdict.state == MoveState::gouge || verdict.state == MoveState::buried;
}

/// The reason that keeps a move from being free.
struct Obstacle {
  Body body = Body::holder;
  MoveState state = MoveState::gouge;

  Obstacle() = default;
  explicit Obstacle(const MoveVerdict& verdict)
      : body(verdict.witness ? verdict.witness->body : verdict.reason.body), state(verdict.state) {}
};

/// A tool at one stick-out, with the checker of its motions.
struct Candidate {
  Candidate(LongerTool&& made, std::size_t tool, const CheckSetup& of, const CheckOptions& options)
      : longer(std::move(made)), setup{{}, longer.heads, of.scene, options} {
    setup.tools.resize(of.tools.size(), nullptr);
    setup.tools[tool] = &longer.bodies;
    checker = std::make_unique<MotionChecker>(setup);
  }
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  LongerTool longer;
  CheckSetup setup;
  std::unique_ptr<MotionChecker> checker;
};

/// The search for one tool. Stick-outs are numbered: 0 is the present one, k is the k-th multiple of the step above it.
class ToolSearch {
 public:
  ToolSearch(const Toolpath& path, const CheckSetup& setup, const MakeLongerTool& make, const StickoutOptions& options,
             const ProgressCall& progress, std::size_t tool, double now_mm)
      : path_(path),
        setup_(setup),
        make_(make),
        options_(options),
        progress_(progress),
        tool_(tool),
        now_mm_(now_mm),
        check_options_(setup.options),
        needs_(path.moves.size(), 0),
        obstacles_(path.moves.size()),
        was_uncertain_(path.moves.size(), false) {
    check_options_.near_miss_mm = 0;
    const double first = std::floor(now_mm / options.step_mm + Tolerance::kRounding);
    first_mm_ = first * options.step_mm;
    max_ = static_cast<std::size_t>(std::max(1.0, std::floor(options.max_longer_mm / options.step_mm)));
  }

  /// Runs the search. Returns nothing for a tool without moves, or without shank, holder and a head above it.
  Result<std::optional<ToolStickout>> run(const CheckResult& result) {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (path_.moves[i].tool == tool_) moves_.push_back(i);
    }
    if (moves_.empty()) return std::optional<ToolStickout>();
    if (Outcome made = candidate(0); !made) return made.error();
    const bool has_bodies = !candidates_.at(0)->longer.bodies.bare.elements.empty();
    if (!has_bodies && setup_.heads.empty()) return std::optional<ToolStickout>();
    const CheckResult bodies = has_bodies ? check_moves(path_, candidates_.at(0)->setup, progress_) : CheckResult();
    const CheckResult& before = has_bodies ? bodies : result;
    std::vector<std::size_t> hit;
    for (const std::size_t i : moves_) {
      const MoveVerdict& verdict = before.verdicts[i];
      was_uncertain_[i] = verdict.state == MoveState::not_certified;
      obstacles_[i] = Obstacle(verdict);
      // If the tool has no bodies of its own, only the head can collide.
      if (is_hit(verdict) && (has_bodies || obstacles_[i].body == Body::head)) hit.push_back(i);
    }
    if (Outcome found = raise(hit, 0); !found) return found.error();
    return collect();
  }

 private:
  [[nodiscard]] double length_mm(std::size_t k) const {
    return k == 0 ? now_mm_ : first_mm_ + static_cast<double>(k) * options_.step_mm;
  }
  [[nodiscard]] bool is_none(std::size_t k) const { return k > max_; }

  Outcome candidate(std::size_t k) {
    if (candidates_.contains(k)) return Done{};
    Result<LongerTool> made = make_(tool_, length_mm(k) - now_mm_);
    if (!made) return made.error();
    candidates_.emplace(k, std::make_unique<Candidate>(std::move(*made), tool_, setup_, check_options_));
    return Done{};
  }

  /// Returns the moves among `moves` that are not free at k.
  Result<std::vector<std::size_t>> not_free(const std::vector<std::size_t>& moves, std::size_t k) {
    if (Outcome made = candidate(k); !made) return made.error();
    const Candidate& at = *candidates_.at(k);
    std::vector<std::uint8_t> are_free(moves.size(), 0);
    for_each_chunk(moves.size(), kMovesPerChunk, check_options_.threads, "looking for stick-outs", progress_,
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t m = first; m < last; ++m) {
                       const std::size_t i = moves[m];
                       const MoveVerdict verdict = at.checker->check(
                           check_options_.law.of(path_, i), run_kind(path_.moves[i]), at.longer.bodies, check_options_);
                       are_free[m] = is_free(verdict) ? 1 : 0;
                       if (!is_free(verdict)) obstacles_[i] = Obstacle(verdict);
                     }
                   });
    std::vector<std::size_t> left;
    for (std::size_t m = 0; m < moves.size(); ++m) {
      if (are_free[m] == 0) left.push_back(moves[m]);
    }
    return left;
  }

  /// Finds the stick-out that each of `moves` needs, first in steps that double, then by halving. Requires that none is
  /// free at k.
  Outcome raise(std::vector<std::size_t> moves, std::size_t k) {
    for (std::size_t step = 1; !moves.empty(); step *= 2) {
      const std::size_t next = std::min(k + step, max_);
      if (k >= max_) {
        for (const std::size_t i : moves) needs_[i] = max_ + 1;
        return Done{};
      }
      Result<std::vector<std::size_t>> left = not_free(moves, next);
      if (!left) return left.error();
      std::vector<std::size_t> freed;
      std::set_difference(moves.begin(), moves.end(), left->begin(), left->end(), std::back_inserter(freed));
      if (Outcome found = halve(freed, k, next); !found) return found;
      moves = std::move(*left);
      k = next;
    }
    return Done{};
  }

  /// Finds the stick-outs by halving. Requires that none of `moves` is free at `low` and all are free at `high`.
  Outcome halve(const std::vector<std::size_t>& moves, std::size_t low, std::size_t high) {
    if (moves.empty()) return Done{};
    if (high - low == 1) {
      for (const std::size_t i : moves) needs_[i] = high;
      return Done{};
    }
    const std::size_t middle = low + (high - low) / 2;
    Result<std::vector<std::size_t>> left = not_free(moves, middle);
    if (!left) return left.error();
    std::vector<std::size_t> freed;
    std::set_difference(moves.begin(), moves.end(), left->begin(), left->end(), std::back_inserter(freed));
    if (Outcome found = halve(freed, low, middle); !found) return found;
    return halve(*left, middle, high);
  }

  /// Checks all moves at k as a path, and returns those that are not free. A longer tool may meet obstacles that the
  /// shorter one did not.
  Result<std::vector<std::size_t>> hit_at(std::size_t k) {
    if (const auto known = hits_.find(k); known != hits_.end()) return known->second;
    if (Outcome made = candidate(k); !made) return made.error();
    const CheckResult all = check_moves(path_, candidates_.at(k)->setup, progress_);
    std::vector<std::size_t> hit;
    for (const std::size_t i : moves_) {
      const MoveVerdict& verdict = all.verdicts[i];
      if (verdict.state == MoveState::not_checked) continue;
      if (is_free(verdict) || (was_uncertain_[i] && !is_hit(verdict))) continue;
      obstacles_[i] = Obstacle(verdict);
      hit.push_back(i);
    }
    return hits_.emplace(k, std::move(hit)).first->second;
  }

  /// Raises the common stick-out of `moves` until all of them are free at it.
  Result<StickoutNeed> need_of(const std::vector<std::size_t>& moves) {
    for (;;) {
      const auto worst = std::max_element(moves.begin(), moves.end(),
                                          [&](std::size_t a, std::size_t b) { return needs_[a] < needs_[b]; });
      const std::size_t k = needs_[*worst];
      StickoutNeed need;
      if (k > 0) {
        need.move = *worst;
        need.body = obstacles_[*worst].body;
        need.state = obstacles_[*worst].state;
      }
      if (is_none(k)) return need;
      need.stickout_mm = length_mm(k);
      if (k == 0) return need;
      Result<std::vector<std::size_t>> hit = hit_at(k);
      if (!hit) return hit.error();
      std::vector<std::size_t> own;
      std::set_intersection(moves.begin(), moves.end(), hit->begin(), hit->end(), std::back_inserter(own));
      if (own.empty()) return need;
      for (const std::size_t i : own) needs_[i] = k + 1;
      if (Outcome found = raise(own, k); !found) return found.error();
    }
  }

  Result<std::optional<ToolStickout>> collect() {
    ToolStickout found;
    found.tool = tool_;
    found.now_mm = now_mm_;
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> by_operation;
    for (const std::size_t i : moves_) {
      const std::size_t operation = path_.moves[i].operation;
      if (by_operation.empty() || by_operation.back().first != operation)
        by_operation.emplace_back(operation, std::vector<std::size_t>());
      by_operation.back().second.push_back(i);
    }
    for (const auto& [operation, moves] : by_operation) {
      Result<StickoutNeed> need = need_of(moves);
      if (!need) return need.error();
      found.operations.push_back({operation, *need});
    }
    Result<StickoutNeed> need = need_of(moves_);
    if (!need) return need.error();
    found.all = *need;
    return std::optional(found);
  }

  const Toolpath& path_;
  const CheckSetup& setup_;
  const MakeLongerTool& make_;
  const StickoutOptions& options_;
  const ProgressCall& progress_;
  std::size_t tool_;
  double now_mm_, first_mm_ = 0;
  std::size_t max_ = 1;
  CheckOptions check_options_;
  std::vector<std::size_t> moves_;   // moves of the tool
  std::vector<std::size_t> needs_;   // by move: the smallest number found; max_ + 1: none
  std::vector<Obstacle> obstacles_;  // by move: the last obstacle that kept it from being free
  std::vector<bool> was_uncertain_;  // by move: it was uncertain at the present stick-out
  std::map<std::size_t, std::unique_ptr<Candidate>> candidates_;
  std::map<std::size_t, std::vector<std::size_t>> hits_;
};

}  // namespace

Result<std::vector<ToolStickout>> find_stickouts(const Toolpath& path, const CheckResult& result,
                                                 const CheckSetup& setup,
                                                 const std::vector<std::optional<double>>& now_mm,
                                                 const MakeLongerTool& make, const StickoutOptions& options,
                                                 const ProgressCall& progress) {
  std::vector<ToolStickout> found;
  for (std::size_t tool = 0; tool < path.tools.size(); ++tool) {
    if (tool >= now_mm.size() || !now_mm[tool]) continue;
    Result<std::optional<ToolStickout>> one =
        ToolSearch(path, setup, make, options, progress, tool, *now_mm[tool]).run(result);
    if (!one) return one.error();
    if (*one) found.push_back(**one);
  }
  return found;
}

}  // namespace gouge
