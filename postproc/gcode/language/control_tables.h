#pragma once

#include "postproc/gcode/language/control_table.h"

namespace gouge {

/// LinuxCNC 2.9.
[[nodiscard]] const ControlTable& linuxcnc_table();
/// Haas, mill, next generation control.
[[nodiscard]] const ControlTable& haas_table();
/// Fanuc 0i, 30i, 31i, milling.
[[nodiscard]] const ControlTable& fanuc_table();

}  // namespace gouge
