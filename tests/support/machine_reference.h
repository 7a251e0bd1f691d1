#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/machine/machine.h"
#include "lib/path/joint_angles.h"

// Motion of a tool on a machine by each law, by 4x4 matrices from the part to the tool. Shares no formula with lib/machine.

namespace gouge::test {

class MachineReference {
 public:
  MachineReference(const Machine& machine, double tool_length_mm) : machine_(machine), length_mm_(tool_length_mm) {}

  /// Both ends of a move; `with_joints` completes them.
  struct Ends {
    Pose from, to;
    RotaryAngles angles0{}, angles1{};
    std::array<double, 5> joints0{}, joints1{};
  };
  [[nodiscard]] Ends with_joints(Ends ends) const {
    ends.joints0 = joints_of(ends.from.tip, ends.angles0);
    ends.joints1 = joints_of(ends.to.tip, ends.angles1);
    return ends;
  }

  /// Tip and axis at t by a law. Rates are those of the machine; all joints that move need one under `independent`.
  [[nodiscard]] Pose at(TurnLaw law, const Ends& ends, double t) const {
    const Vec3 even = ends.from.tip + t * (ends.to.tip - ends.from.tip);
    if (law == TurnLaw::vector) return {even, on_circle(ends.from.axis, ends.to.axis, t)};
    const RigidTransform at = frame(law, ends, t);
    return {at.shift, at.rotation.col(2)};
  }

  /// The frame of the tool with its tip where it is at t on its line, and the rotary joints where they have run `shares`
  /// of their ways.
  [[nodiscard]] RigidTransform frame_at(const Ends& ends, double t, const TurnShares& shares) const {
    std::array<double, 5> q{};
    for (std::size_t k = 0; k < 2; ++k)
      q[machine_.rotary[k]] = (1 - shares[k]) * ends.angles0[k] + shares[k] * ends.angles1[k];
    const Eigen::Matrix4d m = matrix(q);
    return {m.block<3, 3>(0, 0), Vec3(ends.from.tip + t * (ends.to.tip - ends.from.tip))};
  }
  [[nodiscard]] Pose at(const Ends& ends, double t, const TurnShares& shares) const {
    const RigidTransform frame = frame_at(ends, t, shares);
    return {frame.shift, frame.rotation.col(2)};
  }

  /// The frame of the tool at t by a law other than `vector`: origin at the tip, z along the axis.
  [[nodiscard]] RigidTransform frame(TurnLaw law, const Ends& ends, double t) const {
    const std::array<double, 5>&q0 = ends.joints0, &q1 = ends.joints1;
    std::array<double, 5> q{};
    double slowest = 0;
    for (std::size_t k = 0; k < 5; ++k) slowest = std::max(slowest, minutes(k, q1[k] - q0[k]));
    for (std::size_t k = 0; k < 5; ++k) {
      const double own = minutes(k, q1[k] - q0[k]);
      const double gone = law == TurnLaw::independent && own > 0 ? std::min(1.0, t * slowest / own) : t;
      q[k] = (1 - gone) * q0[k] + gone * q1[k];
    }
    const Eigen::Matrix4d m = matrix(q);
    const Vec3 even = ends.from.tip + t * (ends.to.tip - ends.from.tip);
    return {m.block<3, 3>(0, 0), law == TurnLaw::axis ? even : Vec3(m.block<3, 1>(0, 3))};
  }

  [[nodiscard]] std::array<double, 5> joints_of(const Vec3& tip, const RotaryAngles& angles) const {
    std::array<double, 5> q{};
    q[machine_.rotary[0]] = angles[0];
    q[machine_.rotary[1]] = angles[1];
    const Vec3 rest = tip - Vec3(matrix(q).block<3, 1>(0, 3));
    // By Cramer's rule: column k is how the tip moves with linear joint k.
    std::array<Vec3, 3> columns;
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 5> by = q;
      by[machine_.linear[c]] = 1;
      columns[c] = Vec3((matrix(by) - matrix(q)).block<3, 1>(0, 3));
    }
    const double whole = columns[0].dot(columns[1].cross(columns[2]));
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<Vec3, 3> replaced = columns;
      replaced[c] = rest;
      q[machine_.linear[c]] = replaced[0].dot(replaced[1].cross(replaced[2])) / whole;
    }
    return q;
  }

 private:
  [[nodiscard]] double minutes(std::size_t k, double by) const {
    const Joint& joint = machine_.joints[k];
    return joint.rate && std::abs(by) > (joint.type == JointType::rotary ? 1e-12 : 1e-9) ? std::abs(by) / *joint.rate
                                                                                         : 0;
  }

  static Vec3 on_circle(const Vec3& a, const Vec3& b, double t) {
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (angle < 1e-9) return (a + t * (b - a)).normalized();
    return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
  }

  // A rotary joint about the line p + s d: the matrix of Rodrigues, written out, with what it moves p by.
  [[nodiscard]] Eigen::Matrix4d matrix(const std::array<double, 5>& q) const {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    for (std::size_t k = 0; k < 5; ++k) {
      const Joint& joint = machine_.joints[k];
      const Vec3 &d = joint.direction, &p = joint.point;
      Eigen::Matrix4d one = Eigen::Matrix4d::Identity();
      if (joint.type == JointType::linear) {
        one.block<3, 1>(0, 3) = q[k] * d;
      } else {
        const double c = std::cos(q[k]), s = std::sin(q[k]);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) one(i, j) = (i == j ? c : 0) + (1 - c) * d[i] * d[j];
        one(0, 1) -= s * d.z(), one(0, 2) += s * d.y(), one(1, 2) -= s * d.x();
        one(1, 0) += s * d.z(), one(2, 0) -= s * d.y(), one(2, 1) += s * d.x();
        one.block<3, 1>(0, 3) = p - one.block<3, 3>(0, 0) * p;
      }
      m = m * one;
    }
    Eigen::Matrix4d rest = Eigen::Matrix4d::Identity(), tool = Eigen::Matrix4d::Identity();
    rest.block<3, 3>(0, 0) = machine_.rest.rotation;
    rest.block<3, 1>(0, 3) = machine_.rest.shift;
    tool(2, 3) = -length_mm_;
    return m * rest * tool;
  }

  const Machine& machine_;
  double length_mm_;
};

}  // namespace gouge::test
