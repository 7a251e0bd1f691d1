#include "lib/verify/claimed_pose.h"

#include <cmath>

#include "lib/geom/shortest_turn.h"
#include "lib/verify/moving_pose.h"

namespace gouge {
namespace {

constexpr double kSameAxis = 1e-9;

Eigen::Quaterniond turn_from_z(const Vec3& axis) {
  if (1 + axis.z() < 1e-9) return Eigen::Quaterniond(0, 1, 0, 0);  // half a turn about x
  return shortest_turn(Vec3::UnitZ(), axis);
}

/// How the tool runs on a move; on_circle too where its angles are not known.
ClaimedRun run_of(const ClaimedScene& scene, std::size_t index) {
  if (!scene.joints || scene.path.joints == nullptr) return ClaimedRun::on_circle;
  const JointPath& angles = *scene.path.joints;
  const Move& move = scene.path.moves[index];
  if (index >= angles.end.size() || !angles.end[index]) return ClaimedRun::on_circle;
  if (!move.has_start) return scene.joints->feeds;  // a position alone stands at its joints
  if (!angles.start[index]) return ClaimedRun::on_circle;
  return move.kind == MoveKind::rapid ? scene.joints->rapids : scene.joints->feeds;
}

RigidTransform frame_by_joints(const ClaimedScene& scene, std::size_t index, ClaimedRun run, double t) {
  const Move& move = scene.path.moves[index];
  const JointPath& angles = *scene.path.joints;
  const ChainEnds ends = {move.has_start ? scene.path.start_of(index).tip : move.end.tip, move.end.tip,
                          move.has_start ? *angles.start[index] : *angles.end[index], *angles.end[index]};
  return chain_frame(*scene.joints, run, ends, t);
}

}  // namespace

Pose claimed_pose(const ClaimedScene& scene, std::size_t move, double t) {
  Pose pose = pose_at(scene.path, move, t, scene.is_dogleg);
  const ClaimedRun run = run_of(scene, move);
  if (!scene.path.moves[move].has_start || !(t > 0 && t < 1) || run == ClaimedRun::on_circle) return pose;
  const RigidTransform frame = frame_by_joints(scene, move, run, t);
  pose.axis = frame.rotation.col(2);
  if (run != ClaimedRun::rotary && scene.path.moves[move].curve_kind == CurveKind::none) pose.tip = frame.shift;
  return pose;
}

RigidTransform head_frame(const ClaimedScene& scene, std::size_t move, double t) {
  const Pose at = claimed_pose(scene, move, t);
  if (const ClaimedRun run = run_of(scene, move); run != ClaimedRun::on_circle)
    return {frame_by_joints(scene, move, run, t).rotation, at.tip};
  const Pose end = scene.path.moves[move].end;
  const Pose start = scene.path.moves[move].has_start ? scene.path.start_of(move) : end;
  const auto carried = [&](const Vec3& axis) {  // the frame of the start, moved along the great circle to `axis`
    return shortest_turn(start.axis, axis) * turn_from_z(start.axis);
  };
  const Eigen::Matrix3d rest = (carried(end.axis).conjugate() * turn_from_z(end.axis)).toRotationMatrix();
  const double twist = std::atan2(rest(1, 0) - rest(0, 1), rest(0, 0) + rest(1, 1));
  const Eigen::Quaterniond frame = carried(at.axis) * Eigen::AngleAxisd(twist * t, Vec3::UnitZ());
  return {frame.toRotationMatrix(), at.tip};
}

std::optional<std::size_t> find_wrong_joints(const ClaimedScene& scene) {
  for (std::size_t move = 0; move < scene.path.moves.size(); ++move) {
    const ClaimedRun run = run_of(scene, move);
    if (run == ClaimedRun::on_circle) continue;
    const Vec3 from = frame_by_joints(scene, move, run, 0).rotation.col(2),
               to = frame_by_joints(scene, move, run, 1).rotation.col(2);
    const bool has_start = scene.path.moves[move].has_start;
    if ((has_start && (from - scene.path.start_of(move).axis).norm() > kSameAxis) ||
        (to - scene.path.moves[move].end.axis).norm() > kSameAxis)
      return move;
  }
  return std::nullopt;
}

}  // namespace gouge
