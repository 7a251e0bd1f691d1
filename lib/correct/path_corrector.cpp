#include "lib/correct/path_corrector.h"

#include <algorithm>

#include "lib/base/parallel.h"
#include "lib/check/check_options.h"
#include "lib/contact/contacts.h"
#include "lib/correct/laws.h"
#include "lib/motion/motion_law.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr std::size_t kPositionsPerChunk = 4;
// Numbers of bounds for a job, and at least for each position or motion. So the work grows no faster than the size of
// the job. If there are few gouges, each may take as long as many of them together.
constexpr std::uint64_t kJobBudget = 3'000'000, kMinStepBudget = 300'000;

constexpr const char* kWorse = "a change here would make a neighbouring move worse";
constexpr const char* kEndsInStock =
    "the rapid leads into remaining stock, and a cut begins there; only a feed may lead into material";
/// Returns the permitted depth of the cutter in the part after a correction.
double aim_of(double tolerance_mm) { return tolerance_mm > 2 * kAir_mm ? kPositionAimShare * tolerance_mm : -kAir_mm; }

std::uint64_t step_budget(const CheckResult& result) {
  const auto gouges = static_cast<std::uint64_t>(
      std::count_if(result.verdicts.begin(), result.verdicts.end(),
                    [](const MoveVerdict& verdict) { return verdict.state == MoveState::gouge; }));
  return std::max(kMinStepBudget, kJobBudget / std::max<std::uint64_t>(1, gouges));
}

}  // namespace

PathCorrector::PathCorrector(const Toolpath& path, const CheckResult& result,
                             const std::vector<const ToolVariants*>& tools, const MotionChecker& checker,
                             const CorrectOptions& correct, const std::vector<std::size_t>* origin)
    : path_(path),
      result_(result),
      tools_(tools),
      checker_(checker),
      options_(checker.options()),
      correct_(correct),
      origin_(origin),
      step_budget_(step_budget(result)) {
  limits_.aim = {aim_of(options_.tolerance_mm), -kAir_mm, -kAir_mm};
  limits_.largest_shift_mm = correct.max_shift_mm;
  limits_.direction = correct.strategies.direction;
  const Strategy of_cutter = correct.strategies[Body::cutter];
  if (of_cutter != Strategy::axis && of_cutter != Strategy::trim) limits_.of_cutter = of_cutter;
  positions_.resize(path_.moves.size());
  moves_.resize(path_.moves.size());
  choose_positions();
}

void PathCorrector::keep(std::size_t move, const std::string& reason) {
  moves_[move].is_kept = true;
  moves_[move].kept_reason = reason;
  moves_[move].is_dirty = true;
  keep_position(move, reason);
  if (is_chained(move)) keep_position(move - 1, reason);
}

void PathCorrector::keep_position(std::size_t i, const std::string& reason) {
  if (positions_[i].corrected) positions_[i].failure = reason;
  positions_[i].corrected.reset();
  positions_[i].is_worked = true;
  mark_moves_at(i);
}

void PathCorrector::mark_moves_at(std::size_t i) {
  moves_[i].is_dirty = true;
  if (i + 1 < moves_.size()) moves_[i + 1].is_dirty = true;
}

Correction PathCorrector::propose(const ProgressCall& progress) {
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i].is_wanted && !positions_[i].is_worked) wanted.push_back(i);
  }
  work("correcting positions", wanted, progress, [this](std::size_t i) { correct_position(i); });
  // This is done after the parallel work: neighbours share a move, and different threads may have them.
  for (const std::size_t i : wanted) {
    if (positions_[i].corrected) mark_moves_at(i);
  }
  do {
    choose_moves();
    wanted.clear();
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      if (moves_[i].is_wanted && moves_[i].is_dirty) wanted.push_back(i);
    }
    work("joining corrected positions", wanted, progress, [this](std::size_t i) { link_move(i); });
  } while (take_back());
  return gather();
}

bool PathCorrector::is_chained(std::size_t i) const { return i > 0 && path_.moves[i].has_start; }

std::string PathCorrector::reason_to_leave(std::size_t i) const {
  if (!is_straight(path_.moves[i])) return "the position ends an arc or a cycle step";
  if (i + 1 == path_.moves.size() || !path_.moves[i + 1].has_start) return {};
  const Move& next = path_.moves[i + 1];
  if (!is_straight(next)) return "an arc or a step of a cycle begins at the position";
  if (next.tool != path_.moves[i].tool) return "another tool starts at the position";
  return next.not_checked_reason.empty() ? "" : "a move that is not checked begins at the position";
}

void PathCorrector::choose_positions() {
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    if (result_.verdicts[i].state != MoveState::gouge) continue;
    positions_[i].is_wanted = true;
    if (is_chained(i)) positions_[i - 1].is_wanted = true;
    moves_[i].is_dirty = true;
  }
}

/// Returns the strategy for the body with which a move gouges. The tool leaves stock only along its axis.
Strategy PathCorrector::strategy_of(std::size_t i) const {
  const MoveVerdict& verdict = result_.verdicts[i];
  if (verdict.is_in_stock()) return Strategy::axis;
  return correct_.strategies[verdict.witness ? verdict.witness->body : Body::cutter];
}

/// Returns the strategy for the deeper of the two gouges next to a position.
Strategy PathCorrector::strategy_at(std::size_t i) const {
  const auto depth = [this](std::size_t move) {
    const MoveVerdict& verdict = result_.verdicts[move];
    return verdict.state == MoveState::gouge ? verdict.depth_mm : -1;
  };
  const bool has_next = i + 1 < path_.moves.size() && is_chained(i + 1);
  return strategy_of(has_next && depth(i + 1) > depth(i) ? i + 1 : i);
}

/// Returns the checker with the stock that is left before a move.
MotionChecker PathCorrector::checker_of(std::size_t i) const { return checker_.for_move(origin_of(i), is_whole(i)); }

/// Returns whether the tool is in stock at the end of a move, after the programmed cut of that move.
bool PathCorrector::is_end_in_stock(std::size_t i) const {
  return checker_.after_move(origin_of(i), is_whole(i)).stock_excess(path_.moves[i].end) > 0;
}

/// Returns whether a cut begins in the stock in which a rapid or a position alone ends, at that place or after more
/// rapids in it.
bool PathCorrector::is_plunge(std::size_t i) const {
  while (is_whole(i) && is_end_in_stock(i)) {
    if (++i == path_.moves.size() || !path_.moves[i].has_start) return false;
    if (removes_stock(path_.moves[i])) return true;
  }
  return false;
}

void PathCorrector::correct_position(std::size_t i) {
  PositionWork& work = positions_[i];
  work.is_worked = true;
  const Move& move = path_.moves[i];
  if (move.tool == kNone || tools_[move.tool] == nullptr) return;
  const ToolVariants& tool = *tools_[move.tool];
  work.depth_before_mm = depth_at(move.end, i);
  // A position within the tolerance is left alone, even if it is deeper than the aim of a correction. A motion that ends
  // at it must not be too deep there, so the accuracy of the test is taken off.
  const double accuracy = options_.resolution_mm / 4;
  const double within = std::max(0.0, kMotionAimShare * options_.tolerance_mm - accuracy);
  const CorrectionAim allowed{within, within, 0};
  const PoseLimits usual = limits_for(tool);
  PoseLimits now = usual;
  now.aim = allowed;
  const bool is_head_in = head_excess(move.end, checker_, now) > 0;
  const bool is_in_mesh = is_head_in || largest_excess(move.end, tool, checker_.scene(), allowed, accuracy) > 0;
  const bool is_in_stock = is_end_in_stock(i);
  if (!is_in_mesh && !is_in_stock) return;
  work.failure = reason_to_leave(i);
  if (!work.failure.empty()) return;
  const bool is_into_stock = is_in_stock && is_plunge(i);
  if (is_into_stock && !is_in_mesh) {
    work.failure = kEndsInStock;
    return;
  }
  WorkBudget budget(step_budget_);
  const MotionChecker checker = (is_into_stock ? checker_ : checker_of(i)).within(budget);
  const auto freed = [&](const PoseLimits& limits) {
    const bool keeps_room = move.kind == MoveKind::rapid && limits.aim.workpiece_mm < usual.aim.workpiece_mm;
    return free_pose(strategy_at(i), move.end, work.depth_before_mm, move.kind, tool,
                     keeps_room ? checker.keeping_room() : checker, limits, correct_.max_side_shift_mm);
  };
  FreedPose found;
  if (move.kind == MoveKind::rapid) {
    now.aim = {-correct_.rapid_clearance_mm, -correct_.rapid_clearance_mm, -kAir_mm};
    found = freed(now);
  }
  if (!found.corrected) found = freed(usual);
  work.corrected = found.corrected;
  if (!work.corrected) {
    work.failure = budget.is_spent() ? out_of_budget() : found.reason;
    WorkBudget more(step_budget_);
    if (!budget.is_spent()) work.failure += longer_lift(move.end, move.kind, tool, checker_of(i).within(more), usual);
    return;
  }
  work.depth_after_mm = depth_at(work.corrected->pose, i);
}

double PathCorrector::depth_at(const Pose& pose, std::size_t i) const {
  return checker_of(i).measure(pose, run_kind(path_.moves[i]), *tools_[path_.moves[i].tool]).depth_mm;
}

bool PathCorrector::has_new_end(std::size_t i) const {
  return positions_[i].corrected || (is_chained(i) && positions_[i - 1].corrected);
}

void PathCorrector::choose_moves() {
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    const Move& move = path_.moves[i];
    if (!move.has_start && !positions_[i].corrected) continue;
    const bool is_gouging = result_.verdicts[i].state == MoveState::gouge;
    const bool is_linked = is_gouging && move.has_start && is_straight(move) && move.not_checked_reason.empty();
    const bool was_wanted = moves_[i].is_wanted;
    moves_[i].is_wanted = is_linked || has_new_end(i);
    if (was_wanted && !moves_[i].is_wanted) {
      moves_[i].inserted.clear();
      moves_[i].is_failed = moves_[i].is_refused = moves_[i].keeps_start = false;
    }
  }
}

Pose PathCorrector::end_of(std::size_t i) const {
  return positions_[i].corrected ? positions_[i].corrected->pose : path_.moves[i].end;
}

Pose PathCorrector::start_of(std::size_t i) const { return is_chained(i) ? end_of(i - 1) : path_.moves[i].end; }

// Returns the limits for a tool. A thin or pointed tool is clean only at a smaller depth than the tolerance permits.
PoseLimits PathCorrector::limits_for(const ToolVariants& tool) const {
  PoseLimits limits = limits_;
  const CertifiedDepth sure = certified_depth(tool, checker_.scene(), options_);
  const double share = sure.depth_mm > 0 ? sure.depth_mm / (options_.tolerance_mm + options_.resolution_mm) : 0;
  if (share < 1) limits.aim.workpiece_mm = aim_of(share * options_.tolerance_mm);
  return limits;
}

LinkTask PathCorrector::task_of(std::size_t i) const {
  const Move& move = path_.moves[i];
  LinkTask task;
  task.kind = move.kind;
  task.tool = tools_[move.tool];
  task.checker = &checker_;
  task.options = options_;
  const MoveState state = result_.verdicts[i].state;
  task.options.near_miss_mm = state == MoveState::clean ? options_.near_miss_mm : 0;
  task.options.tolerance_mm = kMotionAimShare * options_.tolerance_mm;
  task.limits = limits_for(*task.tool);
  task.rapid_clearance_mm = correct_.rapid_clearance_mm;
  if (move.kind == MoveKind::rapid) {
    const MoveState programmed = verdict_before(i).state;
    task.is_free_as_programmed = programmed == MoveState::clean || programmed == MoveState::near_miss;
  }
  task.largest_side_mm = correct_.max_side_shift_mm;
  task.keeps_to_mm = options_.tolerance_mm;
  return task;
}

void PathCorrector::link_move(std::size_t i) {
  MoveWork& work = moves_[i];
  const Move& move = path_.moves[i];
  work.is_dirty = work.is_failed = work.is_refused = work.is_out_of_budget = work.keeps_start = false;
  work.inserted.clear();
  const bool has_bad_end = !positions_[i].failure.empty() || (is_chained(i) && !positions_[i - 1].failure.empty());
  const bool can_change = move.has_start && is_straight(move) && move.not_checked_reason.empty() && !work.is_kept;
  if (can_change && !has_bad_end) {
    WorkBudget budget(step_budget_);
    auto waypoints = link_with(i, checker_of(i).within(budget));
    // Another gouge shall not stay because stock is in the way. The check of the written path decides about the stock.
    if (!waypoints && checker_of(i).has_stock() && !result_.verdicts[i].is_in_stock())
      waypoints = link_with(i, checker_.within(budget));
    if (waypoints) {
      work.inserted = std::move(*waypoints);
      return;
    }
    work.is_out_of_budget = budget.is_spent();
  }
  work.is_failed = true;
  if (!has_new_end(i) || is_free(i)) return;
  stay_as_programmed(i);
}

/// Links with the strategy of the gouging body. If that is to tilt and no link was found, links with that of the cutter.
std::optional<std::vector<LinkPose>> PathCorrector::link_with(std::size_t i, const MotionChecker& checker) const {
  const Strategy strategy = strategy_of(i);
  auto waypoints = link_as(i, checker, strategy);
  if (!waypoints && strategy == Strategy::tilt && limits_.of_cutter && path_.moves[i].kind == MoveKind::feed)
    waypoints = link_as(i, checker, *limits_.of_cutter);
  return waypoints;
}

std::optional<std::vector<LinkPose>> PathCorrector::link_as(std::size_t i, const MotionChecker& checker,
                                                            Strategy strategy) const {
  LinkTask task = task_of(i);
  task.checker = &checker;
  task.strategy = strategy;
  const Move& move = path_.moves[i];
  const Motion programmed = options_.law.between(path_.start_of(i), move.end, move.kind);
  if (move.kind == MoveKind::feed && programmed.is_defined()) task.programmed = &programmed;
  return link(start_of(i), end_of(i), task);
}

/// Takes back the changes that make a move worse. Returns whether there were any.
bool PathCorrector::take_back() {
  bool is_any = false;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    if (!moves_[i].is_refused) continue;
    moves_[i].is_refused = false;
    is_any = true;
    const std::size_t first = is_chained(i) ? i - 1 : i;
    for (std::size_t k = first; k <= i; ++k) {
      if (positions_[k].corrected) keep_position(k, kWorse);
    }
  }
  return is_any;
}

void PathCorrector::work(std::string_view stage, const std::vector<std::size_t>& wanted, const ProgressCall& progress,
                         const std::function<void(std::size_t)>& what) {
  for_each_chunk(wanted.size(), kPositionsPerChunk, options_.threads, stage, progress,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t k = first; k < last; ++k) what(wanted[k]);
                 });
}

}  // namespace gouge
