#pragma once

#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Returns whether a move is not certified because of a thin feature. Its depth is known then, so it may still prove to
/// be buried.
[[nodiscard]] bool is_thin_feature(const MoveVerdict& verdict);

/// Changes the state of moves that are clean or near: to buried if the tool is inside a solid, to not certified if it
/// may be inside.
///
/// Consider points of the tool that lie deeper in it than any surface comes. They cannot pass from outside to inside
/// during a move, and the last instant of a move is the first one of the next. So each part of the tool that is
/// connected at that depth stays on one side during a whole chain of moves. It is tested once for the chain. A chain
/// ends only at a move without a proof. A move stays clean only if every body of its tool has such a point, and all
/// these points are proved outside. Proof: docs/method/inside_outside.md.
///
/// Cost     O(moves), and O(triangles) for each chain that never leaves the box of the surfaces.
void mark_buried(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                 const CheckOptions& options, MoveVerdicts& verdicts);

}  // namespace gouge
