#pragma once

#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/scene.h"
#include "lib/check/verdict.h"
#include "lib/path/toolpath.h"

namespace gouge {

inline constexpr const char* kSkippedRapid = "rapid moves are skipped as asked";

/// Turns moves that meet no surface although the tool is inside a solid from clean or near to buried.
///
/// While nothing of the surface comes as deep into the tool as its core lies, the core cannot pass from
/// outside to inside; so one winding number tells a whole chain of moves, and only a chain's beginning costs
/// one. Where the tolerance lets the surface come that deep, a move that begins outside is not certified.
///
/// Cost   O(triangles) for each chain whose core is within the mesh's box.
void mark_buried(const Toolpath& toolpath, const std::vector<const ToolForms*>& tools, const Scene& scene,
                 const CheckOptions& options, std::vector<MoveVerdict>& verdicts);

}  // namespace gouge
