#pragma once

#include "lib/drawing/drawing.h"
#include "lib/machine/machine.h"

namespace gouge {

/// Draws the kinematic chain of a machine in a parallel view. The head side with the tool is above, the table side
/// with the part below. Axes have names, positive senses and limits. On the right are the joints in their order, the
/// laws of the control, and a legend.
///
/// Ensures  The same machine gives the same drawing. Distances between axes are to scale within each side.
[[nodiscard]] Drawing draw_machine(const Machine& machine);

}  // namespace gouge
