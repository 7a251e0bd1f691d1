#pragma once

#include "lib/base/parallel.h"
#include "lib/field/checked_toolpath.h"
#include "postproc/export/export_scene.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Builds the exported scene of a checked path. It has parts and fixtures, which are refined where the path gouges,
/// with depth, overcut and the colours of the heat map. It also has the path of the tip, each tool with a gouge at its
/// worst instant, and the heads at the worst instant of all.
///
/// Shape    The `input` belongs to model.toolpath and model.result.
/// Ensures  Depths and overcuts are sampled as for pictures (lib/field) and prove nothing. They are equal on every run
///          and with any number of threads.
/// Cost     About that of a heat map.
[[nodiscard]] ExportScene make_export(const ReportModel& model, const CheckedToolpath& input,
                                      const ProgressCall& progress = {});

}  // namespace gouge
