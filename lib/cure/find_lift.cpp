#include "lib/cure/find_lift.h"

#include <algorithm>
#include <cmath>

#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"
#include "lib/certify/motion_checker.h"
#include "lib/motion/motion_law.h"
#include "lib/path/chords.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerChunk = 8;
constexpr int kStepsByDepth = 64;     // number of lifts that follow from the depth; after them lifts double
constexpr int kWholeChecks = 8;       // number of whole checks below a free lift, if it is not certain that a smaller
                                      // lift is not free
constexpr double kChordShare = 0.25;  // share of the tolerance by which chords may deviate from their curve
constexpr double kAlmost = 1e-6;      // share of a step

bool is_lifted_free(const MoveVerdict& verdict) {
  return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
}

Pose lifted(const Pose& pose, double lift_mm) { return {pose.tip + lift_mm * pose.axis, pose.axis}; }

/// The obstacle that keeps moves from being free at a lift.
struct Block {
  std::size_t move = kNone;  // index in the original path
  Body body = Body::holder;
  MoveState state = MoveState::gouge;
  double depth_mm = 0;
  bool is_proved = false;  // some move is certainly a gouge or buried; gouge_mm is the deepest gouge
  double gouge_mm = 0;
};

class LiftSearch {
 public:
  LiftSearch(const Toolpath& path, const std::vector<std::size_t>& moves, const CheckSetup& setup, double step_mm,
             double max_mm)
      : path_(path),
        moves_(moves),
        options_(setup.options),
        setup_{setup.tools, setup.heads, setup.scene, options_},
        checker_(setup_),
        step_mm_(step_mm),
        max_(static_cast<std::size_t>(std::max(1.0, std::floor(max_mm / step_mm + Tolerance::kRounding)))),
        chord_error_mm_(std::max(kChordShare * setup.options.tolerance_mm, Tolerance::kCorrection_mm)) {
    options_.near_miss_mm = 0;
  }

  LiftCure run() {
    std::size_t low = 0, k = 1;  // the moves are not free at low
    below_.move = moves_.front();
    for (int step = 0;; ++step) {
      std::optional<Block> block = find_block(k);
      if (!block) {
        k = lowest_free(low, k);
        block = find_block_for_sure(k);
        if (!block) return cure(decide_below(k));
      }
      note(k, *block);
      if (k == max_) return cure(std::nullopt);
      low = k;
      k = std::min(next_after(k, *block, step), max_);
    }
  }

 private:
  [[nodiscard]] LiftCure cure(std::optional<std::size_t> k) const {
    LiftCure found;
    if (k) found.lift_mm = static_cast<double>(*k) * step_mm_;
    found.move = below_.move;
    found.body = below_.body;
    found.state = below_.state;
    found.not_free_below_mm = static_cast<double>(k ? std::min(not_free_, *k) : not_free_) * step_mm_;
    return found;
  }

  /// Records the obstacle at k. A lift changes no depth by more than the lift.
  void note(std::size_t k, const Block& block) {
    below_ = block;
    if (!block.is_proved) return;
    const double missing = block.gouge_mm - options_.tolerance_mm - options_.resolution_mm;
    const auto around = static_cast<std::size_t>(std::max(0.0, std::ceil(missing / step_mm_ - kAlmost) - 1));
    if (k <= not_free_ + around) not_free_ = std::max(not_free_, k + around + 1);
  }

  /// Returns the lowest lift that whole checks prove free. Requires that the moves are free at `k`. Runs only while it
  /// is not certain that no smaller lift is free.
  std::size_t decide_below(std::size_t k) {
    std::size_t open = not_free_;  // no lift below is tried
    for (int step = 0; step < kWholeChecks && open < k; ++step) {
      const std::size_t tried = step == 0 ? k - 1 : open + (k - 1 - open) / 2;
      if (const std::optional<Block> block = find_block_for_sure(tried)) {
        note(tried, *block);
        open = std::max(tried + 1, not_free_);
      } else {
        k = tried;
      }
    }
    return k;
  }

  /// Returns the next lift to try. A lift that is smaller than the remaining depth does not free the moves.
  [[nodiscard]] std::size_t next_after(std::size_t k, const Block& block, int step) const {
    if (step >= kStepsByDepth) return 2 * k;
    const double missing = block.depth_mm - options_.tolerance_mm - options_.resolution_mm;
    const auto steps = static_cast<std::size_t>(std::max(0.0, std::floor(missing / step_mm_)));
    return k + std::max<std::size_t>(1, block.state == MoveState::gouge ? steps : k);
  }

  /// Returns a lift that is free while the lift one step below is not. Requires that `high` is free and `low` is not.
  std::size_t lowest_free(std::size_t low, std::size_t high) {
    for (std::size_t k = high - 1; high - low > 1; k = low + (high - low) / 2) {
      if (const std::optional<Block> block = find_block(k)) {
        note(k, *block);
        low = k;
      } else {
        high = k;
      }
    }
    return high;
  }

  [[nodiscard]] LiftedMoves at(std::size_t k) const {
    return lift_moves(path_, moves_, static_cast<double>(k) * step_mm_, chord_error_mm_);
  }

  [[nodiscard]] static Block block_of(std::size_t move, const MoveVerdict& verdict) {
    Block block{move, verdict.witness ? verdict.witness->body : verdict.reason.body, verdict.state, verdict.depth_mm};
    block.is_proved = verdict.state == MoveState::gouge || verdict.state == MoveState::buried;
    return block;
  }

  /// Keeps the worse of two obstacles: the first that is buried or not certified, otherwise the deepest.
  static void take_worse(std::optional<Block>& worst, const Block& block) {
    const auto rank = [](const Block& b) { return b.state == MoveState::gouge ? 0 : 1; };
    const bool is_worse =
        !worst || rank(block) > rank(*worst) || (rank(block) == rank(*worst) && block.depth_mm > worst->depth_mm);
    const double gouge_mm = std::max(worst ? worst->gouge_mm : 0, block.state == MoveState::gouge ? block.depth_mm : 0);
    const bool is_proved = (worst && worst->is_proved) || block.is_proved;
    if (is_worse) worst = block;
    worst->gouge_mm = gouge_mm;
    worst->is_proved = is_proved;
  }

  [[nodiscard]] std::optional<Block> find_block(std::size_t k) const {
    const LiftedMoves moved = at(k);
    const Moves& moves = moved.path.moves;
    MoveVerdicts verdicts(moves.size());
    for_each_chunk(moves.size(), kMovesPerChunk, options_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Motion motion = options_.law.of(moved.path, i);
        if (!motion.is_defined()) verdicts[i].state = MoveState::not_certified;
        if (motion.is_defined())
          verdicts[i] = checker_.check(motion, run_kind(moves[i]), *setup_.tools[moves[i].tool], options_);
      }
    });
    std::optional<Block> worst;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (!is_lifted_free(verdicts[i])) take_worse(worst, block_of(origin_of(moved, i), verdicts[i]));
    }
    return worst;
  }

  /// Returns the same by check(), which knows the path to each move.
  [[nodiscard]] std::optional<Block> find_block_for_sure(std::size_t k) const {
    const LiftedMoves moved = at(k);
    const CheckResult result = check_moves(moved.path, setup_);
    std::optional<Block> worst;
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      if (!is_lifted_free(result.verdicts[i])) take_worse(worst, block_of(origin_of(moved, i), result.verdicts[i]));
    }
    return worst;
  }

  // Returns the original move. A single position is the start of the move after it.
  [[nodiscard]] static std::size_t origin_of(const LiftedMoves& moved, std::size_t i) {
    return moved.origin[i] == kNone ? moved.origin[i + 1] : moved.origin[i];
  }

  const Toolpath& path_;
  const std::vector<std::size_t>& moves_;
  CheckOptions options_;
  CheckSetup setup_;
  MotionChecker checker_;
  double step_mm_;
  std::size_t max_;
  double chord_error_mm_;
  Block below_;
  std::size_t not_free_ = 1;  // proved: no multiple below this is free
};

bool keeps_axis(const Toolpath& path, std::size_t i) {
  return (path.start_of(i).axis - path.moves[i].end.axis).norm() <= Tolerance::kSameDirection;
}

}  // namespace

LiftedMoves lift_moves(const Toolpath& path, const std::vector<std::size_t>& moves, double lift_mm,
                       double chord_error_mm) {
  LiftedMoves all;
  all.path.file = path.file;
  all.path.unit = path.unit;
  all.path.tools = path.tools;
  const auto add = [&](Move move, const Pose& end, std::size_t origin) {
    move.end = lifted(end, lift_mm);
    move.operation = kNone;
    move.statement = kNone;
    move.is_linked = false;
    all.path.moves.push_back(move);
    all.origin.push_back(origin);
  };
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const std::size_t i = moves[k];
    Move move = path.moves[i];
    const bool goes_on = k > 0 && moves[k - 1] + 1 == i;
    if (move.has_start && !goes_on) {
      Move alone = move;
      alone.has_start = false;
      alone.curve_kind = CurveKind::none;
      add(alone, path.start_of(i), kNone);
    }
    const bool is_curve = move.curve_kind != CurveKind::none && move.has_start;
    if (is_curve && !keeps_axis(path, i)) {
      move.curve_kind = CurveKind::none;
      for (const Pose& to : chords_of(path, i, chord_error_mm)) add(move, to, i);
      continue;
    }
    const Vec3 shift = lift_mm * move.end.axis;
    if (is_curve && move.curve_kind == CurveKind::arc) {
      all.path.arcs.push_back(path.arcs[move.curve]);
      all.path.arcs.back().center += shift;
      move.curve = all.path.arcs.size() - 1;
    } else if (is_curve) {
      all.path.splines.push_back(path.splines[move.curve]);
      for (SplinePiece& piece : all.path.splines.back().pieces) {
        for (Vec3& control : piece.control) control += shift;
      }
      move.curve = all.path.splines.size() - 1;
    }
    add(move, path.moves[i].end, i);
  }
  return all;
}

LiftCure find_lift(const Toolpath& path, const std::vector<std::size_t>& moves, const CheckSetup& setup, double step_mm,
                   double max_mm) {
  return LiftSearch(path, moves, setup, step_mm, max_mm).run();
}

}  // namespace gouge
