#pragma once

#include <string>

#include "lib/machine/machine.h"
#include "lib/path/assumption.h"
#include "lib/tool/motion_tube.h"

namespace gouge {

/// Returns the facts of a machine and its control on which a verdict rests beside the law of motion: its kinematics, and
/// the smoothing of the control. `typed` is the machine as the user names it, `tube` the tolerances in force. The
/// argument `has_tolerances` is true if an option states one of them.
[[nodiscard]] Assumptions machine_facts(const Machine& machine, const std::string& typed, const MotionTube& tube,
                                        bool has_tolerances);

}  // namespace gouge
