#include "lib/verify/claimed_pieces.h"

namespace gouge {

std::optional<std::vector<MotionPiece>> claimed_pieces(const ClaimedScene& scene, std::size_t index) {
  const Move& move = scene.path.moves[index];
  if (!scene.joints && scene.axis_law != kGreatCircle) return std::nullopt;
  ClaimedRun run = ClaimedRun::on_circle;
  if (scene.joints && (move.has_start || move.is_linked))
    run = move.has_start ? run_of(*scene.joints, move) : scene.joints->feeds;
  if (run == ClaimedRun::on_circle) return motion_pieces(scene.path, index, scene.is_dogleg);
  const JointPath* const angles = scene.path.joints.get();
  if (!move.has_start || scene.is_dogleg || run == ClaimedRun::any || angles == nullptr ||
      index >= angles->end.size() || !angles->start[index] || !angles->end[index])
    return std::nullopt;
  const ClaimedRun by_joints = run == ClaimedRun::documented ? ClaimedRun::rotary : run;
  auto pieces = motion_pieces(scene.path, index,
                              {&scene.joints_of(index), by_joints, *angles->start[index], *angles->end[index]});
  if (run != ClaimedRun::documented || !pieces) return pieces;
  const auto on_circle = motion_pieces(scene.path, index, scene.is_dogleg);
  if (!on_circle) return std::nullopt;
  pieces->insert(pieces->end(), on_circle->begin(), on_circle->end());
  return pieces;
}

}  // namespace gouge
