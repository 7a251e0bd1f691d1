#include "lib/correct/tilt_path.h"

namespace gouge {

std::vector<bool> moves_to_tilt(const Toolpath& path, const CheckResult& result, const BodyStrategies& strategies) {
  std::vector<bool> is_wanted(path.moves.size(), false);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const MoveVerdict& verdict = result.verdicts[i];
    is_wanted[i] =
        verdict.state == MoveState::gouge && verdict.witness && strategies[verdict.witness->body] == Strategy::tilt;
  }
  return is_wanted;
}

ReworkedPath tilt_path(const Toolpath& path, const CheckResult& result, const std::optional<ReworkedPath>& straight,
                       const TiltPlan& plan, const std::vector<const ToolVariants*>& tools,
                       const MotionChecker& checker) {
  const std::vector<Move>& moves = straight ? straight->path.moves : path.moves;
  const std::vector<MoveVerdict>& verdicts = straight ? straight->result.verdicts : result.verdicts;
  std::vector<std::vector<const TiltedPosition*>> positions(moves.size());
  for (const SmoothedRun& run : plan.runs) {
    for (const TiltedPosition& p : run.positions) positions[p.move].push_back(&p);
  }
  ReworkedPath tilted;
  tilted.path = without_moves(path);
  const auto add = [&](const Move& move, std::size_t origin) {
    const Motion motion = move.has_start ? Motion(tilted.path.moves.back().end, move.end) : Motion(move.end);
    tilted.add(move, origin, true, checker.check(motion, move.kind, *tools[move.tool], checker.options(), true));
  };
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::size_t origin = straight ? straight->origin[i] : i;
    const Move& move = moves[i];
    const bool is_start_moved = move.has_start && i > 0 && !positions[i - 1].empty() && positions[i - 1].back()->is_end;
    if (positions[i].empty() && !is_start_moved) {
      tilted.add(move, origin, straight && straight->is_tilted[i], verdicts[i]);
      continue;
    }
    Move piece = move;
    for (const TiltedPosition* const p : positions[i]) {
      if (p->is_end) continue;
      piece.end = p->pose;
      add(piece, origin);
    }
    piece.end = !positions[i].empty() && positions[i].back()->is_end ? positions[i].back()->pose : move.end;
    add(piece, origin);
  }
  return tilted;
}

}  // namespace gouge
