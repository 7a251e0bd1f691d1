#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "lib/machine/joint_law.h"
#include "lib/machine/joint_path.h"
#include "lib/machine/rotary_law.h"
#include "lib/motion/motion_law.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/machine_reference.h"
#include "tests/support/reference.h"

// Random moves on a machine by each law: the law that is checked, and the frames of the reference. Header only.

namespace gouge::laws {

inline constexpr double kToolLength_mm = 90;

/// A table and a head, whose linear joints depend on the tool, with rates.
inline const Machine& machine_of_campaign() {
  static const Machine kMachine = [] {
    Machine machine = test::machines()[2];
    for (Joint& joint : machine.joints) joint.rate = joint.type == JointType::rotary ? 30 : 2500;
    machine.joints[machine.linear[1]].rate = 4000;
    return machine;
  }();
  return kMachine;
}

inline MotionLaw law_of_campaign(TurnLaw law) {
  const auto by_rotaries = [](LawScope scope) {
    return MotionLaw(RapidMode::straight, std::make_shared<RotaryLaw>(machine_of_campaign(), scope));
  };
  if (law == TurnLaw::vector) return by_rotaries(LawScope::circle);
  if (law == TurnLaw::axis) return by_rotaries(LawScope::one);
  if (law == TurnLaw::documented) return by_rotaries(LawScope::documented);
  if (law == TurnLaw::any) return by_rotaries(LawScope::any);
  const auto timing = law == TurnLaw::joint ? JointTiming::together : JointTiming::independent;
  return {RapidMode::straight, std::make_shared<JointLaw>(machine_of_campaign(), timing, kToolLength_mm)};
}

inline void choose_joints_of_campaign(Toolpath& path) {
  path.joints = std::make_shared<const JointPath>(choose_joints(machine_of_campaign(), path).path);
}

/// The frames of a move by the matrices of the reference; none where the joints are not known. `rest`: the rotary joints
/// rest at these shares of their ways, in place of the law.
inline std::optional<reference::MachineFrames> frames_of(TurnLaw law, const Toolpath& path, std::size_t i,
                                                         const std::optional<TurnShares>& rest = {}) {
  const JointPath& joints = *path.joints;
  const Move& move = path.moves[i];
  if (!joints.end[i] || (move.has_start && !joints.start[i])) return std::nullopt;
  const Pose from = move.has_start ? path.start_of(i) : move.end;
  const RotaryAngles start = move.has_start ? *joints.start[i] : *joints.end[i];
  const test::MachineReference reference(machine_of_campaign(), kToolLength_mm);
  const auto ends = reference.with_joints({from, move.end, start, *joints.end[i], {}, {}});
  const auto frame = [reference, ends, law, rest](double t) {
    return rest ? reference.frame_at(ends, t, *rest) : reference.frame(law, ends, t);
  };
  // How fast it runs at most, by differences, and a margin.
  reference::MachineFrames frames{frame, 0, 0};
  constexpr int kSteps = 200;
  for (int k = 0; k < kSteps; ++k) {
    const RigidTransform a = frame(1.0 * k / kSteps), b = frame((k + 1.0) / kSteps);
    frames.length_mm = std::max(frames.length_mm, 1.1 * kSteps * (b.shift - a.shift).norm());
    const double turned = Eigen::AngleAxisd(a.rotation.transpose() * b.rotation).angle();
    frames.turn_rad = std::max(frames.turn_rad, 1.1 * kSteps * turned);
  }
  return frames;
}

}  // namespace gouge::laws
