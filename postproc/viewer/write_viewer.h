#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/field/checked_toolpath.h"
#include "postproc/image/report_scene.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the 3D view of a report as HTML that needs no other file: its place in the page, style, script, and the
/// scene. It appears if the browser has WebGL2. Otherwise it stays hidden, and the pictures take its place. Empty
/// without triangles.
///
/// Ensures  The bytes are the same on every run and with any number of threads. Positions are rounded to 1/65535 of the
///          scene's extent, so they are no evidence.
/// Errors   page-not-packed.
/// Cost     Less than a heat map; about 6 bytes for each triangle.
[[nodiscard]] Result<std::string> write_viewer(const ReportScene& shown, const ProgressCall& progress = {});

/// Returns the findings for the viewer, one for each gouge, buried tool and near miss of the events, in their order.
/// Each has the position of the tool at the worst instant, the evidence, and the numbers as in the report. It also has
/// the lines of the file around the statement. Coordinates are in mm. Returns only the first `most` of them.
[[nodiscard]] nlohmann::ordered_json finding_texts(const ReportModel& model, const CheckedToolpath& input,
                                                   std::size_t most);

}  // namespace gouge
