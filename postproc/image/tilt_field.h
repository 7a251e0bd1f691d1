#pragma once

#include "postproc/image/heat_map.h"

namespace gouge {

/// Draws the tilted runs of a correction on the part. At positions along them it shows the corrected tool axis, in the
/// colour of its angle to the programmed one. The `set` belongs to the corrected path.
///
/// Requires has_tilt_field(set.model), and at least one direction in the set.
[[nodiscard]] Page draw_tilt_field(const PictureSet& set);

/// Returns whether a correction tilted the tool anywhere.
[[nodiscard]] bool has_tilt_field(const ReportModel& model);

}  // namespace gouge
