#pragma once

#include <string>

#include "lib/base/result.h"
#include "lib/tool/motion_tube.h"

namespace gouge {

/// Reads --tip-tolerance and --axis-tolerance as typed; empty: 0.
/// Errors (code usage): a text that is not a length or an angle, an angle above 10 degrees, and a tube together with
/// heads, whose bodies it does not cover.
[[nodiscard]] Result<MotionTube> understand_tube(const std::string& tip, const std::string& axis, bool has_heads);

}  // namespace gouge
