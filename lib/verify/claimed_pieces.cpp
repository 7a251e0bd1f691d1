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

std::optional<MotionOfMoves> pieces_of_moves(const ClaimedScene& scene, std::size_t first, std::size_t count) {
  MotionOfMoves all;
  for (std::size_t move = first; move < first + count; ++move) {
    const auto own = claimed_pieces(scene, move);
    if (!own) return std::nullopt;
    for (std::size_t k = 0; k < own->size(); ++k) all.of_piece.push_back({move, k});
    all.motion.insert(all.motion.end(), own->begin(), own->end());
  }
  return all;
}

}  // namespace gouge
