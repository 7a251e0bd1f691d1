#include "lib/verify/claimed_chain.h"

#include <algorithm>
#include <cmath>

#include "lib/path/run_kind.h"

namespace gouge {
namespace {

using Eigen::Matrix4d;

Matrix4d shifted(const Vec3& by) {
  Matrix4d m = Matrix4d::Identity();
  m.topRightCorner<3, 1>() = by;
  return m;
}

// The formula of Rodrigues.
Matrix4d turned(const Vec3& k, double angle) {
  Eigen::Matrix3d cross;
  cross << 0, -k.z(), k.y(), k.z(), 0, -k.x(), -k.y(), k.x(), 0;
  const double half = std::sin(0.5 * angle);
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() += std::sin(angle) * cross + 2 * half * half * cross * cross;
  return m;
}

Matrix4d frame_at(const ClaimedJoints& joints, const std::vector<double>& values) {
  Matrix4d m = Matrix4d::Identity();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ClaimedJoint& joint = joints.chain[k];
    if (joint.is_rotary)
      m = m * shifted(joint.point) * turned(joint.direction, values[k]) * shifted(-joint.point);
    else
      m = m * shifted(values[k] * joint.direction);
  }
  Matrix4d rest = shifted(joints.rest.shift);
  rest.topLeftCorner<3, 3>() = joints.rest.rotation;
  return m * rest * shifted({0, 0, -joints.tool_length_mm});
}

Vec3 origin_of(const Matrix4d& m) { return m.topRightCorner<3, 1>(); }

/// All joints for a tip, which is affine in the linear ones.
std::vector<double> values_for(const ClaimedJoints& joints, const RotaryAngles& angles, const Vec3& tip) {
  std::vector<double> values(joints.chain.size(), 0);
  for (std::size_t k = 0; k < 2; ++k) values[joints.rotary[k]] = angles[k];
  const Vec3 rest = tip - origin_of(frame_at(joints, values));
  Eigen::Matrix3d ways = Eigen::Matrix3d::Zero();
  std::vector<std::size_t> linear;
  for (std::size_t k = 0; k < values.size() && linear.size() < 3; ++k) {
    if (joints.chain[k].is_rotary) continue;
    std::vector<double> one = values;
    one[k] += 1;
    ways.col(static_cast<Eigen::Index>(linear.size())) =
        origin_of(frame_at(joints, one)) - origin_of(frame_at(joints, values));
    linear.push_back(k);
  }
  const Vec3 found = ways.fullPivLu().solve(rest);
  for (std::size_t c = 0; c < linear.size(); ++c) values[linear[c]] = found[static_cast<Eigen::Index>(c)];
  return values;
}

/// The part of each joint's way that it has run at t.
std::vector<double> shares_at(const ClaimedJoints& joints, ClaimedRun run, const std::vector<double>& by, double t) {
  std::vector<double> shares(by.size(), t), minutes(by.size(), 0);
  if (run != ClaimedRun::independent) return shares;
  std::size_t moving = 0;
  for (std::size_t k = 0; k < by.size(); ++k) {
    const ClaimedJoint& joint = joints.chain[k];
    if (std::abs(by[k]) <= (joint.is_rotary ? kClaimedStand_rad : kClaimedStand_mm)) continue;
    ++moving;
    if (joint.rate) minutes[k] = std::abs(by[k]) / *joint.rate;
  }
  const double whole = *std::ranges::max_element(minutes);
  if (moving < 2 || !(whole > 0)) return shares;
  for (std::size_t k = 0; k < by.size(); ++k) {
    if (minutes[k] > 0) shares[k] = std::min(1.0, t * whole / minutes[k]);
  }
  return shares;
}

}  // namespace

ClaimedRun run_of(const ClaimedJoints& joints, const Move& move) {
  const bool is_rapid = runs_rapid(move);
  if (move.runs_joints) return is_rapid ? joints.joint_rapids : joints.joint_feeds;
  return is_rapid ? joints.rapids : joints.feeds;
}

RigidTransform chain_frame(const ClaimedJoints& joints, ClaimedRun run, const ChainEnds& ends, double t) {
  const std::vector<double> from = values_for(joints, ends.angles0, ends.tip0),
                            to = values_for(joints, ends.angles1, ends.tip1);
  std::vector<double> by(from.size());
  for (std::size_t k = 0; k < by.size(); ++k) by[k] = to[k] - from[k];
  const std::vector<double> shares = shares_at(joints, run, by, t);
  std::vector<double> values = from;
  for (std::size_t k = 0; k < by.size(); ++k) values[k] += shares[k] * by[k];
  const Matrix4d m = frame_at(joints, values);
  return {m.topLeftCorner<3, 3>(), origin_of(m)};
}

}  // namespace gouge
