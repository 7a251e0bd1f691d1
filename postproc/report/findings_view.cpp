#include "postproc/report/findings_view.h"

#include <algorithm>

namespace gouge {
namespace {

// Deeper is larger: the distance of a near miss is below zero.
double rank_of(const ReportModel& model, std::size_t index) {
  const Event& event = model.result->events[index];
  const MoveVerdict& verdict = model.result->verdicts[event.worst_move];
  if (event.state == MoveState::buried) return std::numeric_limits<double>::infinity();
  return event.state == MoveState::near_miss ? -verdict.clearance_mm.value_or(0) : verdict.depth_mm;
}

bool is_listed(const ReportModel& model, const Event& event, double min_depth_mm) {
  if (min_depth_mm <= 0 || event.state == MoveState::buried) return true;
  if (event.state != MoveState::gouge) return false;
  for (std::size_t move = event.first_move; move <= event.last_move; ++move) {
    if (model.result->verdicts[move].depth_upper_mm >= min_depth_mm) return true;
  }
  return false;
}

}  // namespace

ListedFindings list_events(const ReportModel& model, const FindingsView& view) {
  ListedFindings listed;
  const std::vector<Event>& events = model.result->events;
  for (std::size_t k = 0; k < events.size(); ++k) {
    const MoveState state = events[k].state;
    if (state != MoveState::gouge && state != MoveState::buried && state != MoveState::near_miss) continue;
    if (is_listed(model, events[k], view.min_depth_mm)) {
      listed.events.push_back(k);
    } else {
      ++listed.shallower;
    }
  }
  const bool is_cut = listed.events.size() > view.most;
  if (!view.is_deepest_first && !is_cut) return listed;
  std::ranges::stable_sort(listed.events, std::ranges::greater{}, [&](std::size_t k) { return rank_of(model, k); });
  if (is_cut) {
    listed.more = listed.events.size() - view.most;
    listed.deepest_more_mm = std::max(0.0, rank_of(model, listed.events[view.most]));
    listed.events.resize(view.most);
  }
  if (!view.is_deepest_first) std::ranges::sort(listed.events);
  return listed;
}

}  // namespace gouge
