#pragma once

#include <algorithm>
#include <cmath>

#include "lib/machine/kinematics.h"
#include "tests/support/machine_reference.h"
#include "tests/support/scatter.h"

// Random moves on chains of joints, to compare two descriptions of one machine by matrices of the test's own.

namespace gouge::test {

/// Returns two random poses with their angles.
inline MachineReference::Ends random_ends(const Machine& machine, Scatter& scatter) {
  MachineReference::Ends ends;
  for (RotaryAngles* const angles : {&ends.angles0, &ends.angles1})
    for (double& angle : *angles) angle = scatter.in(-3, 3);
  for (Pose* const pose : {&ends.from, &ends.to})
    for (int k = 0; k < 3; ++k) pose->tip[k] = scatter.in(-100, 100);
  ends.from.axis = tool_axes(machine, ends.angles0).col(2);
  ends.to.axis = tool_axes(machine, ends.angles1).col(2);
  return ends;
}

/// Returns whether no two linear joints are nearly parallel at an end, where small changes need long ways.
inline bool is_within_travel(const MachineReference::Ends& ends) {
  constexpr double kMaxJoint_mm = 3000;
  const auto is_near = [](double value) { return std::abs(value) < kMaxJoint_mm; };
  return std::ranges::all_of(ends.joints0, is_near) && std::ranges::all_of(ends.joints1, is_near);
}

/// Returns how far the tips by two descriptions of a machine come apart in random moves between the same poses.
inline double largest_difference(const Machine& machine, const MachineReference& one, const MachineReference& other,
                                 TurnLaw law, Scatter& scatter) {
  double largest = 0;
  for (int n = 0; n < 20; ++n) {
    const MachineReference::Ends ends = random_ends(machine, scatter);
    const MachineReference::Ends of_one = one.with_joints(ends), of_other = other.with_joints(ends);
    if (!is_within_travel(of_one) || !is_within_travel(of_other)) continue;
    for (double t = 0; t <= 1; t += 1.0 / 16)
      largest = std::max(largest, (one.at(law, of_one, t).tip - other.at(law, of_other, t).tip).norm());
  }
  return largest;
}

}  // namespace gouge::test
