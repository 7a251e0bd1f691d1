#include "lib/tilt/cut_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

// Maximum work for the amount of stock left. A tilt is refused because too much is left; the amount only appears in the
// reason.
constexpr std::size_t kWorkOnceLeft = 60'000;

}  // namespace

CutPath::ReplacedMoves CutPath::replaced_by(const TiltSpace& space) {
  ReplacedMoves replaced;
  for (std::size_t i = 0; i + 1 < space.size(); ++i) {
    const TiltPosition &from = space[i], &to = space[i + 1];
    replaced[to.move].push_back({from.move == to.move ? from.t : 0.0, to.t});
  }
  return replaced;
}

std::vector<CutPath::Cut> CutPath::tilted(const TiltSpace& space, const TiltSequence& tilts, std::size_t tool) const {
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i + 1 < space.size(); ++i) {
    if (space[i + 1].kind == MoveKind::rapid) continue;
    const auto from = space.pose(i, tilts[i]), to = space.pose(i + 1, tilts[i + 1]);
    if (from && to) cuts.push_back({law().straight(*from, *to), tool, space[i + 1].move});
  }
  return cuts;
}

/// Adds the unchanged moves and parts of moves that are near a ball.
void CutPath::add_unchanged(const ReplacedMoves& replaced, const Vec3& centre, double radius_mm,
                            CutterSweep& sweep) const {
  const Moves& moves = job_.path.moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Move& move = moves[i];
    if (runs_rapid(move) || !move.has_start || move.tool == kNone || job_.tools[move.tool] == nullptr) continue;
    const CompiledTool& cutter = job_.tools[move.tool]->cutting;
    // No point of the move is farther from the middle between its ends than half of its length.
    const Pose& start = job_.path.start_of(i);
    const double away = (0.5 * (start.tip + move.end.tip) - centre).norm();
    if (cutter.elements.empty() || away > radius_mm + 0.5 * move_length_mm(job_.path, i) + farthest_mm(cutter))
      continue;
    const auto found = replaced.find(i);
    if (found == replaced.end()) {
      const Motion motion = law().of(job_.path, i);
      if (motion.is_defined()) sweep.add(motion, cutter, i);
      continue;
    }
    // The pieces of a straight move between its replaced stretches.
    const Motion motion = law().straight(start, move.end);
    std::vector<Replaced> stretches = found->second;
    std::ranges::sort(stretches, {}, &Replaced::from);
    double from = 0;
    stretches.push_back({1, 1});
    for (const Replaced& stretch : stretches) {
      if (stretch.from > from) sweep.add(law().straight(motion.at(from), motion.at(stretch.from)), cutter, i);
      from = std::max(from, stretch.to);
    }
  }
}

std::optional<LeftStock> CutPath::left_by(const TiltSpace& space, const TiltSequence& tilts) const {
  const std::size_t tool = tool_of(space);
  const CompiledTool& cutter = job_.tools[tool]->cutting;
  const double allowed_mm = job_.options.max_stock_mm;
  if (cutter.elements.empty() || !(allowed_mm < std::numeric_limits<double>::infinity())) return std::nullopt;
  CutterSweep before, own, others;
  Vec3 low = space[0].programmed.tip, high = low;
  for (std::size_t i = 0; i + 1 < space.size(); ++i) {
    const bool is_as_it_was = !(tilts[i].norm() > 0) && !(tilts[i + 1].norm() > 0);
    if (is_as_it_was || space[i + 1].kind == MoveKind::rapid) continue;
    before.add(law().straight(space[i].programmed, space[i + 1].programmed), cutter, space[i + 1].move);
    for (const std::size_t k : {i, i + 1}) {
      low = low.cwiseMin(space[k].programmed.tip);
      high = high.cwiseMax(space[k].programmed.tip);
    }
  }
  for (const Cut& cut : tilted(space, tilts, tool)) own.add(cut.motion, cutter, cut.move);
  ReplacedMoves replaced = replaced_;
  for (const auto& [move, stretches] : replaced_by(space)) {
    std::vector<Replaced>& all = replaced[move];
    all.insert(all.end(), stretches.begin(), stretches.end());
  }
  const double radius_mm = 0.5 * (high - low).norm() + farthest_mm(cutter);
  add_unchanged(replaced, 0.5 * (low + high), radius_mm, others);
  for (const Cut& cut : accepted_) others.add(cut.motion, job_.tools[cut.tool]->cutting, cut.move);
  for (CutterSweep* const sweep : {&before, &own, &others}) sweep->index();
  const SweepsAfter after = {&own, &others};
  const CheckOptions& options = job_.checker.options();
  StockLimits limits{options.tolerance_mm, options.tolerance_mm + allowed_mm, kMaxStock_mm};
  limits.are_solids = job_.checker.scene().is_workpiece_solid();
  limits.max_work_once_left = kWorkOnceLeft;
  return find_left_stock(job_.checker.scene().workpiece_tree(), before, after, limits);
}

void CutPath::accept(const TiltSpace& space, const TiltSequence& tilts) {
  for (const auto& [move, stretches] : replaced_by(space)) {
    std::vector<Replaced>& all = replaced_[move];
    all.insert(all.end(), stretches.begin(), stretches.end());
  }
  for (Cut& cut : tilted(space, tilts, tool_of(space))) accepted_.push_back(std::move(cut));
}

}  // namespace gouge
