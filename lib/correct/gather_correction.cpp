#include <algorithm>
#include <string>

#include "lib/correct/path_corrector.h"

// Gathers the changes of a search, and the reasons of moves that stay.

namespace gouge {
namespace {

constexpr const char* kToolBuried = "the tool is buried: there is no way out to follow";
constexpr const char* kHeadBuried = "the head is buried: there is no way out to follow";
constexpr const char* kCycleStep =
    "a step of a drilling cycle that no lift of its hole frees: it takes another depth, clearance height or order of "
    "the holes";
constexpr const char* kRound = "an arc or curve that no change of its positions frees";
constexpr const char* kCycleInStock =
    "a step of a drilling cycle in remaining stock: holes are not lifted for stock; it takes a longer tool, or a cut "
    "before that removes the stock";
constexpr const char* kNoWayOverStock =
    "no clear way over the remaining stock was found: the way up from its start or down to its end is blocked";
constexpr const char* kRapidStays = "a rapid that stays begins at its end, and only a feed may lead back there: ";
constexpr const char* kUncertain = "the check cannot tell whether it is clean, so neither can a correction";

}  // namespace

std::string usual_reason(const Move& move, const MoveVerdict& verdict, double max_shift_mm) {
  const std::string within = "within " + max_shift_text(max_shift_mm);
  if (verdict.state == MoveState::buried) return verdict.reason.body == Body::head ? kHeadBuried : kToolBuried;
  if (verdict.state == MoveState::not_certified) return kUncertain;
  if (move.kind == MoveKind::cycle) return verdict.is_in_stock() ? kCycleInStock : kCycleStep;
  if (verdict.is_in_stock() && move.kind == MoveKind::rapid) return kNoWayOverStock;
  if (verdict.is_in_stock())
    return "remaining stock is in the way of shank or holder, and no lift " + within +
           " frees them; it takes a longer tool, or a cut before that removes the stock";
  if (!is_straight(move)) return kRound;
  if (verdict.witness && verdict.witness->body == Body::head)
    return "the head is in the way between its positions: no clean path was found " + within +
           "; it takes another tilt or a longer tool";
  return "no clean path was found between its positions " + within;
}

std::string PathCorrector::out_of_budget() const {
  return "the budget of " + std::to_string(step_budget_) +
         " bounds for this step was spent; a larger tolerance or resolution needs fewer";
}

/// Returns whether a feed with a corrected end goes on to its programmed end, because a rapid that stays begins there.
bool PathCorrector::returns_to_end(std::size_t i) const {
  return positions_[i].corrected && i + 1 < moves_.size() && moves_[i + 1].keeps_start;
}

/// Returns the positions that are inserted before the end of a move.
std::vector<LinkPose> PathCorrector::stops_of(std::size_t i) const {
  std::vector<LinkPose> stops = moves_[i].inserted;
  if (!returns_to_end(i)) return stops;
  // A feed that itself stays as programmed visits that end last, before the new end.
  if (moves_[i].is_failed && !stops.empty()) {
    stops.pop_back();
  } else {
    stops.push_back({*positions_[i].corrected, path_.moves[i].end, positions_[i].depth_before_mm});
  }
  return stops;
}

Correction PathCorrector::gather() const {
  Correction correction;
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    gather_records(i, correction);
    PathChange change;
    change.move = i;
    if (positions_[i].corrected && !returns_to_end(i)) change.new_end = positions_[i].corrected->pose;
    for (const LinkPose& stop : stops_of(i)) change.inserted_before.push_back(stop.corrected.pose);
    if (change.new_end || !change.inserted_before.empty()) correction.changes.push_back(change);
    gather_failure(i, correction);
  }
  return correction;
}

void PathCorrector::gather_records(std::size_t i, Correction& correction) const {
  // A search that finds no witness states no depth.
  const double in_stock = result_.verdicts[i].is_in_stock() ? result_.verdicts[i].depth_mm : 0;
  for (const LinkPose& stop : stops_of(i)) {
    const double after = depth_at(stop.corrected.pose, i);
    correction.records.push_back({i, stop.corrected.strategy, true, stop.corrected.pose.tip - stop.before.tip,
                                  std::max(stop.depth_before_mm, in_stock), after, stop.corrected.iterations, 0,
                                  stop.corrected.pose});
  }
  const PositionWork& p = positions_[i];
  if (!p.corrected || returns_to_end(i)) return;
  correction.records.push_back({i, p.corrected->strategy, false, p.corrected->pose.tip - path_.moves[i].end.tip,
                                p.depth_before_mm, p.depth_after_mm, p.corrected->iterations, 0, p.corrected->pose});
}

/// Returns the reason why a move that gouges or is buried stays.
std::string PathCorrector::reason_of(std::size_t i) const {
  const MoveVerdict& verdict = result_.verdicts[i];
  const MoveWork& work = moves_[i];
  std::string reason = usual_reason(path_.moves[i], verdict, correct_.max_shift_mm);
  if (verdict.state != MoveState::gouge) return reason;
  if (work.is_out_of_budget) reason = out_of_budget();
  if (is_straight(path_.moves[i]) && !work.kept_reason.empty()) reason = work.kept_reason;
  if (!positions_[i].failure.empty() && path_.moves[i].kind != MoveKind::cycle) return positions_[i].failure;
  if (is_chained(i) && !positions_[i - 1].failure.empty() && is_straight(path_.moves[i]))
    return "it begins at a position that stays: " + positions_[i - 1].failure;
  return reason;
}

void PathCorrector::gather_failure(std::size_t i, Correction& correction) const {
  const MoveVerdict& verdict = result_.verdicts[i];
  const MoveWork& work = moves_[i];
  const bool is_gouge = verdict.state == MoveState::gouge;
  if (!is_gouge && verdict.state != MoveState::buried) return;
  const bool is_found = work.is_wanted && !work.is_failed, returns = returns_to_end(i);
  if (is_found && !returns) return;
  // A single position that was corrected does not gouge any more.
  if (!path_.moves[i].has_start && positions_[i].corrected) return;
  const std::string reason = is_found ? kRapidStays + reason_of(i + 1) : reason_of(i);
  correction.uncorrected.push_back({.move = i, .depth_mm = is_gouge ? verdict.depth_mm : 0, .reason = reason});
}

}  // namespace gouge
