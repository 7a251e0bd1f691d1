#include "lib/correct/tilt_path.h"

#include <algorithm>

#include "lib/correct/straighten.h"

namespace gouge {

std::vector<bool> moves_to(Strategy wanted, const Toolpath& path, const CheckResult& result,
                           const BodyStrategies& strategies) {
  std::vector<bool> is_wanted(path.moves.size(), false);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const MoveVerdict& verdict = result.verdicts[i];
    const bool is_buried = verdict.state == MoveState::buried && wanted == Strategy::trim;
    // From remaining stock feeds are tilted or lifted, and rapids are lifted: crossings are planned about meshes.
    const bool may_leave_stock = wanted == Strategy::tilt && path.moves[i].kind != MoveKind::rapid;
    const bool is_gouge =
        verdict.state == MoveState::gouge && verdict.witness && (!verdict.is_in_stock() || may_leave_stock);
    const bool continues =
        may_leave_stock && i > 0 && is_wanted[i - 1] && path.moves[i].has_start && may_be_in_stock(verdict);
    if (continues) is_wanted[i] = true;
    if (!is_buried && !is_gouge) continue;
    is_wanted[i] = strategies[is_buried ? verdict.reason.body : verdict.witness->body] == wanted;
  }
  return is_wanted;
}

TiltProposal propose_tilts(const TiltRequest& request, const ProgressCall& progress) {
  const auto& [path, result, tools, checker, strategies, options, may_tilt] = request;
  TiltProposal proposal;
  const std::vector<bool> is_wanted = moves_to(Strategy::tilt, path, result, strategies);
  const bool is_any = std::ranges::find(is_wanted, true) != is_wanted.end();
  const auto near = is_any && may_tilt ? moves_near(path, is_wanted, options.blend_mm) : std::vector<bool>();
  proposal.straight = straighten(path, result, tools, checker, near);
  if (!is_any) return proposal;
  const Toolpath& base = proposal.straight ? proposal.straight->path : path;
  const CheckResult& verdicts = proposal.straight ? proposal.straight->result : result;
  proposal.is_wanted = moves_to(Strategy::tilt, base, verdicts, strategies);
  const std::vector<std::size_t>* const origin = proposal.straight ? &proposal.straight->origin : nullptr;
  if (may_tilt)
    proposal.plan = plan_tilts({base, verdicts, tools, checker, options, proposal.is_wanted, origin}, progress);
  return proposal;
}

ReworkedPath tilt_path(const Toolpath& path, const CheckResult& result, const std::optional<ReworkedPath>& straight,
                       const TiltPlan& plan, const std::vector<const ToolVariants*>& tools,
                       const MotionChecker& checker) {
  const ReworkedPath* const base = straight ? &*straight : nullptr;
  const Moves& moves = base != nullptr ? base->path.moves : path.moves;
  std::vector<NewPosition> positions;
  for (const SmoothedRun& run : plan.runs) {
    for (const TiltedPosition& p : run.positions) positions.push_back({p.move, p.is_end, p.pose, moves[p.move].kind});
  }
  std::ranges::stable_sort(positions, {}, &NewPosition::move);
  return with_positions(path, result, base, positions, tools, checker);
}

}  // namespace gouge
