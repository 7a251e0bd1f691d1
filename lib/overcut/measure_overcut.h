#pragma once

#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// Gives every gouging move its overcut: how far below the surface of the part (or fixture) of its witness
/// the tool as it is, without clearances and stock, reached. Where depth saturates at the tool's radius,
/// overcut does not.
///
/// Of a gouge whose witness is in a head it is the head that is followed, not the tool. Bodies whose surface
/// is not closed have no inside and get none; a gouge into a clearance alone has 0.
/// Ensures  overcut <= true overcut <= overcut_upper in every move, the overcut realised at a point. For the worst move
///          of an event both lie within 1 % or 0.002 mm of each other wherever 400 cells of space suffice for that; the
///          others are searched less, and theirs may be some millimetres apart. The same bits at any number of threads.
/// Cost     a tree over each body that is gouged, then about a millisecond for the worst move of each event and a tenth
///          of one for every other.
/// Requires result.events.
void measure_overcuts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                      const PreparedScene& scene, const CheckOptions& options, CheckResult& result,
                      const std::vector<HeadBody>& heads);

}  // namespace gouge
