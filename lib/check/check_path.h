#pragma once

#include <vector>

#include "lib/base/checkpoints.h"
#include "lib/base/parallel.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Checks the tools of a toolpath along every move. This is one part of a verdict; lib/certify gives the complete one.
///
/// Shape    `tools[k]` belongs to toolpath.tools[k]. If it is null or missing, that tool has no definition and its
///          moves are not checked.
/// Ensures  (1) The result has one verdict for each move, in order, and otherwise only the number of computed bounds. A
///          move is not checked if the path lacks its start or curve (a move cut out of another path). (2) The result
///          is the same, bit for bit, at any number of threads. (3) A move is clean only if every body of the tool is
///          proved outside of all solids during it. It is buried only if one is proved inside; otherwise it is not
///          certified (buried.h). (4) The result is the same if stretches of it come from `kept`, which may be null.
/// Source   Design of docs/method/guarantee.md; docs/method/certified_sweep.md.
[[nodiscard]] CheckResult check_path(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                                     const PreparedScene& scene, const CheckOptions& options,
                                     const ProgressCall& progress = {}, CheckpointStore* kept = nullptr);

/// Returns the reason why a single position is not checked: the link to it is not clean. Requires a link
/// (MotionLaw::link_of).
[[nodiscard]] Reason link_reason(const Toolpath& toolpath, std::size_t index);

}  // namespace gouge
