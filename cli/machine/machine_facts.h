#pragma once

#include <optional>
#include <string>

#include "lib/machine/machine.h"
#include "lib/motion/motion_law.h"
#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"
#include "lib/tool/motion_tube.h"

namespace gouge {

/// A machine as the user states it.
struct MachineStatement {
  std::string typed;            ///< the machine as the user names it
  MotionTube tube;              ///< the tolerances in force
  bool has_tolerances = false;  ///< an option states one of them
};

/// Returns the facts of a machine and its control on which a verdict rests beside the law of motion: its kinematics, and
/// the smoothing of the control. Without a part zero the axes of the machine are those of the part. A path whose frame
/// turns X, Y and Z contradicts this. Without a machine (null) there is only the fact about a smoothing that the path states;
/// it is unknown unless a tolerance is stated.
[[nodiscard]] Assumptions machine_facts(const Machine* machine, const MachineStatement& stated, const Toolpath& path);

/// Returns the fact about the way of rapids; none, if it is stated, or if it is the same anyway. Rapids of CL data without a
/// machine are taken to run straight. Dog-legs have linear axes along X, Y and Z of the part: a frame of the path that turns
/// X, Y and Z contradicts it, and so does a machine whose linear joints have other directions in a rapid. Null machine: none
/// is given. Requires Toolpath::joints with a machine.
[[nodiscard]] std::optional<Assumption> rapid_fact(const Toolpath& path, const MotionLaw& law, const Machine* machine);

}  // namespace gouge
