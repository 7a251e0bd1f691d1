#pragma once

#include <cstddef>
#include <vector>

#include "lib/machine/machine.h"

namespace gouge {

/// Returns whether all joints run by a law, so that tip and axis follow from the kinematics of the machine.
[[nodiscard]] bool runs_joints(TurnLaw law);

/// A fact that a law needs and that is not given.
struct MissingFact {
  enum class Kind {
    point,        ///< on the axis of a rotary joint
    tool_length,  ///< from the gauge point to the tip, if depends_on_tool_length
    part_zero,    ///< if depends_on_part_zero
    rate          ///< of a joint; moves of several joints that need it are not checked
  };
  Kind kind = Kind::point;
  std::size_t joint = 0;  ///< of Machine::joints; without meaning for the tool length and the part zero
};

/// Returns the facts that a law lacks on a machine: points, then the tool length and the part zero, then rates.
[[nodiscard]] std::vector<MissingFact> missing_facts(const Machine& machine, TurnLaw law, bool has_tool_length);

/// A doubt about the data of a machine.
struct MachineDoubt {
  enum class Kind {
    no_limits,         ///< a rotary joint turns without known limits
    no_linear_limits,  ///< a linear joint has no limits
    no_rate,           ///< a joint has no rate
    fixed,             ///< a joint has equal limits
    idle,              ///< a rotary joint turns the tool about its own axis
    not_at_zero,       ///< the limits of a joint do not contain 0
    preference         ///< the limits of a joint exclude the preferred sign
  };
  Kind kind = Kind::no_limits;
  std::vector<std::size_t> joints;  ///< of Machine::joints
};

/// Returns the doubts about a machine, in the order of their kinds.
[[nodiscard]] std::vector<MachineDoubt> find_doubts(const Machine& machine);

/// Tool axes that a machine reaches within the limits of its rotary joints, rad from the tool axis at joints 0.
struct AxisReach {
  double least = 0, most = 0;  ///< smallest and largest angle of a reachable axis
  double whole = 0;            ///< up to this angle the machine reaches every direction; negative: not even joints 0
};

/// Measures the reachable axes at directions one degree apart. Cost: 65,000 solutions of the inverse problem.
[[nodiscard]] AxisReach measure_reach(const Machine& machine);

}  // namespace gouge
