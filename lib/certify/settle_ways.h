#pragma once

#include "lib/check/check_result.h"
#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"

namespace gouge {

struct CheckSetup;

/// Lists in the fact "complete" that CL data state no way to the first position of a tool and from its last one
/// (Move::begins_stretch), and opens the fact where the tool cannot come or leave straight along its axis.
///
/// Ensures  (1) A way from a clean position, out of the box of all parts and fixtures, is proved free of gouges with
///          tolerance and resolution of the check, or the fact is unknown. With joints of a machine the heads are left out,
///          because no angles belong to that motion. (2) Ways from other positions, and remaining stock, are not examined.
///          (3) A fact that is open already stays as it is. (4) The result is the same at any number of threads.
/// Cost     One motion for each way, two ways for each stretch.
void settle_ways(const Toolpath& path, const CheckSetup& setup, const MoveVerdicts& verdicts, Assumptions& facts);

}  // namespace gouge
