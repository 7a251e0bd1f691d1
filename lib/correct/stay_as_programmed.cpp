#include "lib/correct/laws.h"
#include "lib/correct/path_corrector.h"
#include "lib/motion/motion_law.h"
#include "lib/path/run_kind.h"

// Moves that still gouge although an end of them moves. They run as programmed, and only shifts of their ends are added.
// No rapid leads back to its programmed start: that would be a plunge. The feed before it returns to that start.

namespace gouge {

/// Finds positions for a move for which no clean path was found. If there are none, the changes of its ends are refused.
void PathCorrector::stay_as_programmed(std::size_t i) {
  MoveWork& work = moves_[i];
  if (runs_rapid(path_.moves[i]) && is_chained(i) && positions_[i - 1].corrected) {
    // A rapid that meets stock in any case need not meet the part too. The check of the written path compares the stock.
    if (checker_.meets_stock(origin_of(i)) && is_free_with(i, checker_)) return;
    work.keeps_start = may_return(i - 1);
    work.is_refused = !work.keeps_start;
    if (work.is_refused) return;
  }
  auto again = programmed_again(i, work.keeps_start);
  work.is_refused = !again;
  if (again) work.inserted = std::move(*again);
}

/// Returns whether a shift between a programmed and a new position is no worse than move `i`.
bool PathCorrector::is_shift_lawful(std::size_t i, const Pose& from, const Pose& to) const {
  const Move& move = path_.moves[i];
  const Motion motion = options_.law.straight(from, to);
  return motion.is_defined() &&
         is_no_worse_than(verdict_before(i), checker_.check(motion, move.kind, *tools_[move.tool], options_),
                          options_.resolution_mm);
}

/// Returns whether move `i` is a straight feed that may end with the way from its new end back to its programmed end.
bool PathCorrector::may_return(std::size_t i) const {
  const Move& move = path_.moves[i];
  return move.has_start && is_straight(move) && !runs_rapid(move) && move.not_checked_reason.empty() &&
         is_shift_lawful(i, end_of(i), move.end);
}

/// Returns positions with which a still gouging move runs as it was programmed. It leads from its new start to the old
/// one, unless it keeps that, along the programmed motion, and from the old end to the new one. So it cuts nothing new,
/// except for the shifts of its ends, which are no deeper than the ends. Returns nothing if that does not hold, or if
/// the motion is not a straight line.
std::optional<std::vector<LinkPose>> PathCorrector::programmed_again(std::size_t i, bool keeps_start) const {
  const Move& move = path_.moves[i];
  std::vector<LinkPose> again;
  if (keeps_start && !positions_[i].corrected) return again;
  const bool is_dogleg = move.kind == MoveKind::rapid && options_.law.rapid() == RapidMode::dogleg;
  if (!move.has_start || !is_straight(move) || !move.not_checked_reason.empty() || is_dogleg) return std::nullopt;
  const double depth = verdict_before(i).depth_mm;
  const auto visit = [&](const Pose& pose) { again.push_back({{pose, Strategy::axis, 0, 0}, pose, depth}); };
  const Pose& start = path_.start_of(i);
  if (!keeps_start && positions_[i - 1].corrected) {
    if (!is_shift_lawful(i, start_of(i), start)) return std::nullopt;
    visit(start);
  }
  if (positions_[i].corrected) {
    if (!is_shift_lawful(i, move.end, end_of(i))) return std::nullopt;
    visit(move.end);
  }
  return again;
}

// Returns the verdict before the correction. A rapid that is left out on request is checked here, because it exists
// nevertheless.
MoveVerdict PathCorrector::verdict_before(std::size_t i) const {
  const MoveVerdict& verdict = result_.verdicts[i];
  if (verdict.state != MoveState::not_checked || !verdict.reason.is(Reason::Kind::rapid_skipped)) return verdict;
  return checker_.check(options_.law.of(path_, i), run_kind(path_.moves[i]), *tools_[path_.moves[i].tool], options_);
}

/// Returns whether a move with its new ends is clean, or near if it was not clean before.
bool PathCorrector::is_free(std::size_t i) const {
  return is_free_with(i, path_.moves[i].kind == MoveKind::rapid ? checker_of(i) : checker_);
}

bool PathCorrector::is_free_with(std::size_t i, const MotionChecker& checker) const {
  const Move& move = path_.moves[i];
  if ((move.has_start && !is_straight(move)) || !move.not_checked_reason.empty()) return false;
  const Motion motion =
      move.has_start ? options_.law.between(start_of(i), end_of(i), move.kind) : options_.law.at(end_of(i));
  if (!motion.is_defined()) return false;
  const MoveVerdict after = checker.check(motion, move.kind, *tools_[move.tool], options_);
  return after.state != MoveState::gouge && is_no_worse_than(verdict_before(i), after, options_.resolution_mm);
}

}  // namespace gouge
