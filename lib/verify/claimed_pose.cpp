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

Eigen::Quaterniond turn(const Vec3& direction, double angle) {
  const Vec3 v = std::sin(0.5 * angle) * direction;
  return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

bool runs_by_joints(const ClaimedScene& scene, std::size_t move) {
  if (!scene.joints || scene.path.joints == nullptr) return false;
  const JointPath& angles = *scene.path.joints;
  const bool is_rapid = scene.path.moves[move].kind == MoveKind::rapid;
  return (is_rapid ? scene.joints->in_rapids : scene.joints->in_feeds) && move < angles.end.size() &&
         angles.start[move] && angles.end[move];
}

Eigen::Quaterniond turn_by_joints(const ClaimedScene& scene, std::size_t move, double t) {
  const RotaryAngles &from = *scene.path.joints->start[move], &to = *scene.path.joints->end[move];
  return turn(scene.joints->first, from[0] + t * (to[0] - from[0])) *
         turn(scene.joints->second, from[1] + t * (to[1] - from[1]));
}

}  // namespace

Pose claimed_pose(const ClaimedScene& scene, std::size_t move, double t) {
  Pose pose = pose_at(scene.path, move, t, scene.is_dogleg);
  if (t > 0 && t < 1 && runs_by_joints(scene, move)) pose.axis = turn_by_joints(scene, move, t) * Vec3::UnitZ();
  return pose;
}

RigidTransform head_frame(const ClaimedScene& scene, std::size_t move, double t) {
  const Pose at = claimed_pose(scene, move, t);
  if (runs_by_joints(scene, move)) return {turn_by_joints(scene, move, t).toRotationMatrix(), at.tip};
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
    if (!scene.path.moves[move].has_start || !runs_by_joints(scene, move)) continue;
    const Vec3 from = turn_by_joints(scene, move, 0) * Vec3::UnitZ(),
               to = turn_by_joints(scene, move, 1) * Vec3::UnitZ();
    if ((from - scene.path.start_of(move).axis).norm() > kSameAxis ||
        (to - scene.path.moves[move].end.axis).norm() > kSameAxis)
      return move;
  }
  return std::nullopt;
}

}  // namespace gouge
