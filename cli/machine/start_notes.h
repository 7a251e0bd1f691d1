#pragma once

#include "lib/base/diagnostic.h"
#include "lib/machine/machine.h"
#include "lib/motion/motion_law.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns a note for each rotary joint that would turn otherwise if it began whole turns away. Without a move that runs by
/// joints there is none. Requires Toolpath::joints.
[[nodiscard]] Diagnostics describe_other_starts(const Machine& machine, const MotionLaw& law, const Toolpath& path);

}  // namespace gouge
