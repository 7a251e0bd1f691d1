#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/field/checked_toolpath.h"
#include "postproc/image/report_scene.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Returns the 3D view of a report as HTML that needs nothing beside it: its place in the page, style, script, and the
/// scene. It shows itself where a browser has WebGL2, else it stays hidden and the pictures represent it. Empty without
/// triangles.
///
/// Ensures  The same bytes on every run and at any number of threads. Positions are rounded to 1/65535 of the scene's
///          extent: a picture, no evidence.
/// Errors   page-not-packed.
/// Cost     Less than a heat map; about 6 bytes a triangle.
[[nodiscard]] Result<std::string> write_viewer(const ReportScene& shown, const ProgressCall& progress = {});

/// Returns the findings for the viewer, one for each gouge, buried tool and near miss of the events, in their order.
/// Each holds the position of the tool at the worst instant, the evidence, and the numbers as the report writes them.
/// It also holds the lines of the file around the statement. Lengths of coordinates in mm. At most `most` of them, the
/// first.
[[nodiscard]] nlohmann::ordered_json finding_texts(const ReportModel& model, const CheckedToolpath& input,
                                                   std::size_t most);

}  // namespace gouge
