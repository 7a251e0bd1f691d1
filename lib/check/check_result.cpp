#include "lib/check/check_result.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace gouge {
namespace {

bool is_reported(const MoveVerdict& v) { return v.state != MoveState::clean && v.state != MoveState::not_checked; }

bool belongs(const Event& event, const Move& last, const Move& move, const MoveVerdict& v) {
  if (event.state != v.state || last.tool != move.tool || last.operation != move.operation) return false;
  return !v.witness || v.state == MoveState::buried ||
         (event.body == v.witness->body && event.against == v.witness->against);
}

bool is_worse(const MoveVerdict& a, const MoveVerdict& b) {
  if (a.clearance_mm && b.clearance_mm) return *a.clearance_mm < *b.clearance_mm;
  return a.depth_mm > b.depth_mm;
}

std::vector<Event> gather_events(const Toolpath& toolpath, const MoveVerdicts& verdicts) {
  std::vector<Event> events;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const MoveVerdict& v = verdicts[i];
    if (!is_reported(v)) continue;
    const Move& move = toolpath.moves[i];
    const bool is_next = !events.empty() && events.back().last_move + 1 == i &&
                         (v.state != MoveState::buried || v.reason.is_same(verdicts[i - 1].reason));
    if (is_next && belongs(events.back(), toolpath.moves[i - 1], move, v)) {
      Event& event = events.back();
      event.last_move = i;
      ++event.moves;
      if (is_worse(v, verdicts[event.worst_move])) event.worst_move = i;
      continue;
    }
    Event event;
    event.state = v.state;
    event.first_move = event.last_move = event.worst_move = i;
    event.moves = 1;
    event.tool = move.tool;
    if (v.witness) {
      event.body = v.witness->body;
      event.against = v.witness->against;
    }
    if (v.state == MoveState::buried) event.body = v.reason.body;
    events.push_back(event);
  }
  return events;
}

void count_states(CheckResult& result) {
  // The counts in the order of MoveState.
  static constexpr std::array<std::size_t StateCounts::*, 6> kCountOf = {
      &StateCounts::clean,  &StateCounts::near_miss,   &StateCounts::gouge,
      &StateCounts::buried, &StateCounts::not_checked, &StateCounts::not_certified};
  result.counts = {};
  result.worst_depth_mm = result.largest_gap_mm = 0;
  result.worst_move = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const MoveVerdict& v = result.verdicts[i];
    ++(result.counts.*kCountOf[static_cast<std::size_t>(v.state)]);
    if (v.state == MoveState::not_checked && v.reason.is(Reason::Kind::rapid_skipped)) ++result.counts.skipped;
    if (v.state != MoveState::gouge) continue;
    // The bounds of a depth in stock are as wide as its own resolution allows.
    if (!v.is_in_stock()) result.largest_gap_mm = std::max(result.largest_gap_mm, v.depth_upper_mm - v.depth_mm);
    if (v.depth_mm > result.worst_depth_mm) {
      result.worst_depth_mm = v.depth_mm;
      result.worst_move = i;
    }
  }
}

}  // namespace

std::span<const FurtherContact> CheckResult::further_of(std::size_t move) const {
  const auto first = std::ranges::lower_bound(further, move, {}, &FurtherContact::move);
  const auto last = std::ranges::upper_bound(further, move, {}, &FurtherContact::move);
  return {first, last};
}

void summarise(const Toolpath& toolpath, CheckResult& result) {
  result.events = gather_events(toolpath, result.verdicts);
  count_states(result);
}

}  // namespace gouge
