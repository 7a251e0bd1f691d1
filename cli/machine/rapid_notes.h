#pragma once

#include "lib/machine/machine.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns a warning, convert-rapid, if rapids of a program are no straight moves, or may be none, because several joints
/// run each at its own rate. CL data state straight rapids alone. `machine`: in part coordinates, with the law of its
/// control.
[[nodiscard]] Diagnostics find_lost_rapids(const Machine& machine, const Toolpath& path);

}  // namespace gouge
