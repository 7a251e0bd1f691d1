#pragma once

#include <vector>

#include "lib/base/parallel.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// Finds the further contacts of gouging moves. The verdict of a move has the deepest place of the whole tool. Here each
/// body is searched alone against each obstacle, except the body and the obstacle of the verdict.
///
/// Ensures  A body that is deeper in an obstacle than its limit plus the resolution is in result.further, of every
///          gouging move. A contact with a witness has depth <= true depth <= depth_upper, measured in the body alone.
///          The result has the same bits at any number of threads.
/// Requires ToolVariants::alone. Of a tool without it, only contacts of the heads are found.
/// Cost     For each gouging move some microseconds for each body and obstacle.
/// Source   Own, docs/method/guarantee.md
void find_further_contacts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                           const PreparedScene& scene, const CheckOptions& options, const std::vector<HeadBody>& heads,
                           CheckResult& result, const ProgressCall& progress = {});

}  // namespace gouge
