#pragma once

#include "lib/field/checked_toolpath.h"
#include "postproc/image/colour_scale.h"
#include "postproc/report/report_model.h"

// The colours of a report, in every picture of it the same. Those of a correction cover the path before it, so that
// both can be compared.

namespace gouge {

/// Of the depths of moves.
[[nodiscard]] ColourScale depth_scale(const ReportModel& model, const CheckedToolpath& input);

/// Of what colours the surface: overcuts, and the depths of gouges without one or of a head.
[[nodiscard]] ColourScale surface_scale(const ReportModel& model, const CheckedToolpath& input);

}  // namespace gouge
