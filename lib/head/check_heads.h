#pragma once

#include <vector>

#include "lib/check/check_path.h"
#include "lib/head/head_body.h"

namespace gouge {

/// Checks bodies that move with the tool, and that its profile does not hold, along every move that the tool
/// was checked on, and joins what it finds to `result`: the deeper witness stays, a gouge of either is a
/// gouge, and a move is clean only if both are.
///
/// The promise is the tool's: depth <= true depth <= depth_upper over every instant; clean means that
/// depth_upper is at most tolerance + resolution and that no head lies inside a solid (Body::head in witness
/// and events). Ensures  the same bits at any number of threads.
void check_heads(const Toolpath& toolpath, const std::vector<HeadBody>& heads, const Scene& scene,
                 const CheckOptions& options, CheckResult& result);

}  // namespace gouge
