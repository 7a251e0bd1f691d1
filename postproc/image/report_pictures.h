#pragma once

#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "postproc/image/report_scene.h"
#include "postproc/report/named_file.h"

namespace gouge {

/// Loads the module that draws pictures (mask_painter.h), so that an error is known before the work.
/// Errors   module-missing, out-of-memory.
[[nodiscard]] Outcome load_pictures();

/// Draws the pictures of a report as PNG, 1600 x 1000: heat_map.png, depth_along_path.png, and event_1.png to
/// event_6.png for the worst findings. If the model has a correction with its path and verdicts before it, it also
/// draws before_after.png. If the correction tilted the tool, it also draws tilt_field.png.
///
/// Ensures  The bytes are equal on every run and with any number of threads.
/// Errors   Code picture-not-encoded. A picture of a scene without triangles is left out; this is no error.
/// Cost     Seconds; grows with the number of triangles and of gouging moves.
[[nodiscard]] Result<std::vector<NamedFile>> draw_report_pictures(const ReportScene& shown,
                                                                  const ProgressCall& progress = {});

}  // namespace gouge
