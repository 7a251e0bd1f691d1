#pragma once

#include <optional>

#include "lib/machine/machine.h"
#include "lib/motion/motion_law.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Adds the laws of moves without tool centre point control to the law of a job, if the path has such moves. Feeds run by
/// the law joint, rapids by TurnLaws::joint_rapids.
/// Error: machine-law, the machine or the tool length has intervals, which these laws do not cover.
[[nodiscard]] std::optional<Diagnostic> add_joint_laws(const Machine& machine, const TurnLaws& laws,
                                                       const std::optional<double>& tool_length_mm,
                                                       double tool_length_slack_mm, const Toolpath& path,
                                                       MotionLaw& law);

}  // namespace gouge
