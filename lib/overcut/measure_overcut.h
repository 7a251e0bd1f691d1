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

/// Gives every gouging move its overcut. That is how far the tool as it is, without clearances and stock, reached below
/// the surface of the part (or fixture) of its witness. Where depth saturates at the tool's radius, overcut does not.
///
/// For a gouge whose witness is in a head the overcut is that of the head, not of the tool. Bodies whose surface is not
/// closed have no inside and get none; a gouge into a clearance alone has 0.
/// Ensures  In every move, overcut <= true overcut <= overcut_upper, and the overcut is realised at a point. Both are
///          within 1 % or 0.002 mm of each other wherever the cells of OvercutOptions suffice for that. The same bits
///          at any number of threads.
/// Requires result.events: their worst moves are searched longest.
/// Cost     Some 10 microseconds a move of a tool that is blunt where it gouges, else up to a millisecond or a few.
void measure_overcuts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                      const PreparedScene& scene, const CheckOptions& options, CheckResult& result,
                      const std::vector<HeadBody>& heads, const ProgressCall& progress = {},
                      CheckpointStore* kept = nullptr);

}  // namespace gouge
