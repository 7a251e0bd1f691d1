#pragma once

#include <vector>

#include "lib/base/checkpoints.h"
#include "lib/base/parallel.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// Gives every gouging move its overcut. That is how far the tool reached below the surface of the part (or fixture) of
/// its witness. The tool is taken without clearances and stock to leave. Depth cannot exceed the tool's radius, but
/// overcut can.
///
/// If the witness of a gouge is in a head, the overcut is that of the head, not of the tool. Bodies whose surface is
/// not closed have no inside and get no overcut; a gouge that only enters a clearance has 0.
/// Ensures  In every move, overcut <= true overcut <= overcut_upper, and a real point has the overcut. The two bounds
///          differ by at most 1 % or 0.002 mm if the cells of OvercutOptions suffice. The result has the same bits at
///          any number of threads.
/// Requires result.events, whose worst moves are searched longest.
/// Cost     Some 10 microseconds for a move of a tool that is blunt where it gouges; otherwise up to a few
///          milliseconds.
void measure_overcuts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                      const PreparedScene& scene, const CheckOptions& options, CheckResult& result,
                      const std::vector<HeadBody>& heads, const ProgressCall& progress = {},
                      CheckpointStore* kept = nullptr);

}  // namespace gouge
