#include "postproc/report/shares.h"

#include <algorithm>

#include "postproc/report/findings_html.h"
#include "postproc/report/remedies.h"

namespace gouge {
namespace {

/// Counts for each operation or tool; `of(move)` is its index. Moves without one are counted last.
template <class Of>
std::vector<Share> shares_of(const ReportModel& model, std::size_t count, Of&& of) {
  std::vector<Share> shares(count + 1);
  const auto at = [&](std::size_t move) -> Share& { return shares[std::min(of(model.toolpath->moves[move]), count)]; };
  for (std::size_t i = 0; i < model.toolpath->moves.size(); ++i) ++at(i).moves;
  for (std::size_t i = 0; i < model.result->events.size(); ++i) {
    const Event& event = model.result->events[i];
    if (event.state != MoveState::gouge && event.state != MoveState::buried) continue;
    Share& share = at(event.worst_move);
    ++share.findings;
    const FindingCures* const cures = model.cure_options ? cures_of(model, i) : nullptr;
    if (cures != nullptr && (cures->tilt.tilt_rad || cures->lift.lift_mm)) ++share.cured;
    if (event.state == MoveState::gouge)
      share.depth_mm = std::max(share.depth_mm, model.result->verdicts[event.worst_move].depth_mm);
    share.overcut_mm = std::max(share.overcut_mm, overcut_of(model, event));
  }
  return shares;
}

}  // namespace

std::vector<Share> shares_of_operations(const ReportModel& model) {
  return shares_of(model, model.toolpath->operations.size(),
                   [](const Move& move) -> std::size_t { return move.operation; });
}

std::vector<Share> shares_of_tools(const ReportModel& model) {
  return shares_of(model, model.toolpath->tools.size(), [](const Move& move) -> std::size_t { return move.tool; });
}

Share sum_of(const std::vector<Share>& shares) {
  Share sum;
  for (const Share& one : shares) {
    sum.moves += one.moves;
    sum.findings += one.findings;
    sum.cured += one.cured;
    sum.depth_mm = std::max(sum.depth_mm, one.depth_mm);
    sum.overcut_mm = std::max(sum.overcut_mm, one.overcut_mm);
  }
  return sum;
}

}  // namespace gouge
