#pragma once

#include <string>
#include <string_view>

#include "lib/machine/machine.h"

namespace gouge {

/// Returns whether a text is the configuration of a LinuxCNC machine: it has a section [KINS].
[[nodiscard]] bool is_linuxcnc_ini(std::string_view bytes);

/// Reads kinematics, rotary directions, limits and rates of a LinuxCNC configuration. Of the limits and rates of an axis
/// and of its joint the narrower ones are taken. Pivots are not read.
/// Errors, with the line: machine-ini. The KINEMATICS are not known, LINEAR_UNITS is missing or unknown, or no HALCMD
/// sets the rotary directions. Or a limit or rate is not a number.
/// Source   LinuxCNC, INI Configuration: [KINS], [HAL], [TRAJ], [AXIS_<letter>], [JOINT_<number>];
///          src/emc/kinematics/trtfuncs.c.
[[nodiscard]] Result<Machine> read_linuxcnc_ini(const std::string& file, std::string_view bytes);

/// Returns a warning that names the axes without a section, if their limits are not known otherwise.
[[nodiscard]] Diagnostics describe_missing_axes(const Machine& machine, const std::string& file);

}  // namespace gouge
