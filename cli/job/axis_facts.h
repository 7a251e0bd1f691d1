#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// The speed of --max-rotary-speed in degrees a minute; none: not given.
using RotaryLimit = std::optional<double>;

/// Nothing typed: no limit. Error (code usage): names the option, what was typed and what was expected.
[[nodiscard]] Result<RotaryLimit> understand_rotary_limit(const std::string& typed);

/// Axes of `before` and of `after`, which `changes` made of it.
[[nodiscard]] AxisFacts measure_axes(const Toolpath& before, const std::vector<PathChange>& changes,
                                     const Toolpath& after, const RotaryLimit& limit);

}  // namespace gouge
