#pragma once

#include "lib/base/parallel.h"
#include "lib/field/checked_toolpath.h"
#include "postproc/export/export_scene.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Builds the exported scene of a checked path. It holds parts and fixtures, cut finer where the path gouges, with
/// depth, overcut and the colours of the heat map. It also holds the path of the tip. Each tool with a gouge is there
/// at its worst instant, and the heads at the worst of all.
///
/// Shape    The `input` belongs to model.toolpath and model.result.
/// Ensures  Depths and overcuts are sampled as for pictures (lib/field) and prove nothing. The same on every run and at
///          any number of threads.
/// Cost     About a heat map.
[[nodiscard]] ExportScene make_export(const ReportModel& model, const CheckedToolpath& input,
                                      const ProgressCall& progress = {});

}  // namespace gouge
