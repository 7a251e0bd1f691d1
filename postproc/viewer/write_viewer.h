#pragma once

#include <string>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "postproc/image/report_scene.h"

namespace gouge {

/// The 3D view of a report as HTML that needs nothing beside it: its place in the page, style, script, and the scene. It
/// shows itself where a browser has WebGL2, else it stays hidden and the pictures stand for it. Empty without triangles.
///
/// Ensures  The same bytes on every run and at any number of threads. Positions are rounded to 1/65535 of the scene's
///          extent: a picture, no evidence.
/// Errors   page-not-packed.
/// Cost     Less than a heat map; about 6 bytes a triangle.
[[nodiscard]] Result<std::string> write_viewer(const ReportScene& shown, const ProgressCall& progress = {});

}  // namespace gouge
