#include "lib/verify/claimed_pose.h"

#include <cmath>

#include "lib/geom/shortest_turn.h"
#include "lib/verify/moving_pose.h"

namespace gouge {
namespace {

constexpr double kSameAxis = 1e-9;

Eigen::Quaterniond turn_from_z(const Vec3& axis) {
  if (axis.z() < 0 && !(axis.head<2>().squaredNorm() > 0))
    return Eigen::Quaterniond(0, 1, 0, 0);  // half a turn about x
  return shortest_turn(Vec3::UnitZ(), axis);
}

/// Returns whether the joints of a machine and their angles at both ends of a move are known.
bool has_angles(const ClaimedScene& scene, std::size_t index) {
  if (!scene.joints || scene.path.joints == nullptr) return false;
  const JointPath& angles = *scene.path.joints;
  return index < angles.end.size() && angles.end[index] && (!scene.path.moves[index].has_start || angles.start[index]);
}

}  // namespace

ClaimedRun claimed_run_of(const ClaimedScene& scene, std::size_t index) {
  if (!has_angles(scene, index)) return ClaimedRun::on_circle;
  const Move& move = scene.path.moves[index];
  if (!move.has_start) return scene.joints->feeds;  // a position alone stands at its joints
  return run_of(*scene.joints, move);
}

namespace {

/// The single motion of a law that admits several, which the shares of the rotary joints choose.
ClaimedRun run_with(const ClaimedScene& scene, std::size_t index, const std::optional<TurnShares>& turn) {
  const ClaimedRun run = claimed_run_of(scene, index);
  if (run == ClaimedRun::documented) return turn ? ClaimedRun::rotary : ClaimedRun::on_circle;
  return run == ClaimedRun::any ? ClaimedRun::rotary : run;
}

RigidTransform frame_by_joints(const ClaimedScene& scene, std::size_t index, ClaimedRun run, double t,
                               const std::optional<TurnShares>& turn) {
  const Move& move = scene.path.moves[index];
  const JointPath& angles = *scene.path.joints;
  ChainEnds ends = {move.has_start ? scene.path.start_of(index).tip : move.end.tip, move.end.tip,
                    move.has_start ? *angles.start[index] : *angles.end[index], *angles.end[index]};
  if (!turn) return chain_frame(scene.joints_of(index), run, ends, t);
  for (std::size_t k = 0; k < 2; ++k)
    ends.angles0[k] = ends.angles1[k] = ends.angles0[k] + (*turn)[k] * (ends.angles1[k] - ends.angles0[k]);
  return chain_frame(scene.joints_of(index), run, ends, t);
}

}  // namespace

bool admits(const ClaimedScene& scene, std::size_t move, double t, const TurnShares& turn) {
  const ClaimedRun run = claimed_run_of(scene, move);
  constexpr double kRounding = 1e-12;
  if (run == ClaimedRun::documented) return std::abs(turn[0] - t) <= kRounding && std::abs(turn[1] - t) <= kRounding;
  const auto is_share = [](double share) { return share >= 0 && share <= 1; };
  return run == ClaimedRun::any && is_share(turn[0]) && is_share(turn[1]);
}

Pose claimed_pose(const ClaimedScene& scene, std::size_t move, double t, const std::optional<TurnShares>& turn) {
  Pose pose = pose_at(scene.path, move, t, scene.is_dogleg);
  const ClaimedRun run = run_with(scene, move, turn);
  const bool is_at_end = !(t > 0 && t < 1) && !turn;
  if (!scene.path.moves[move].has_start || is_at_end || run == ClaimedRun::on_circle) return pose;
  const RigidTransform frame = frame_by_joints(scene, move, run, t, turn);
  pose.axis = frame.rotation.col(2);
  if (run != ClaimedRun::rotary && scene.path.moves[move].curve_kind == CurveKind::none) pose.tip = frame.shift;
  return pose;
}

RigidTransform head_frame(const ClaimedScene& scene, std::size_t move, double t,
                          const std::optional<TurnShares>& turn) {
  const Pose at = claimed_pose(scene, move, t, turn);
  if (const ClaimedRun run = run_with(scene, move, turn); run != ClaimedRun::on_circle)
    return {frame_by_joints(scene, move, run, t, turn).rotation, at.tip};
  const Pose end = scene.path.moves[move].end;
  const Pose start = scene.path.moves[move].has_start ? scene.path.start_of(move) : end;
  const auto frame_at_end = [&](double share, const Vec3& axis) {
    if (!has_angles(scene, move)) return turn_from_z(axis);
    const TurnShares at_end{share, share};
    return Eigen::Quaterniond(frame_by_joints(scene, move, ClaimedRun::rotary, 0, at_end).rotation);
  };
  const Eigen::Quaterniond first = frame_at_end(0, start.axis), last = frame_at_end(1, end.axis);
  const auto carried = [&](const Vec3& axis) {  // the frame of the start, moved along the great circle to `axis`
    return shortest_turn(start.axis, axis) * first;
  };
  const Eigen::Matrix3d rest = (carried(end.axis).conjugate() * last).toRotationMatrix();
  const double twist = std::atan2(rest(1, 0) - rest(0, 1), rest(0, 0) + rest(1, 1));
  const Eigen::Quaterniond frame = carried(at.axis) * Eigen::AngleAxisd(twist * t, Vec3::UnitZ());
  return {frame.toRotationMatrix(), at.tip};
}

std::optional<std::size_t> find_wrong_joints(const ClaimedScene& scene) {
  for (std::size_t move = 0; move < scene.path.moves.size(); ++move) {
    if (claimed_run_of(scene, move) == ClaimedRun::on_circle) continue;
    const auto axis_at = [&](double share) {
      return Vec3(frame_by_joints(scene, move, ClaimedRun::rotary, 0, TurnShares{share, share}).rotation.col(2));
    };
    const Vec3 from = axis_at(0), to = axis_at(1);
    const bool has_start = scene.path.moves[move].has_start;
    if ((has_start && (from - scene.path.start_of(move).axis).norm() > kSameAxis) ||
        (to - scene.path.moves[move].end.axis).norm() > kSameAxis)
      return move;
  }
  return std::nullopt;
}

}  // namespace gouge
