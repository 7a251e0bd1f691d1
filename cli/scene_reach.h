#pragma once

#include "lib/check/scene.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// No point of the scene is farther than this from any tip the path has, between positions too: the diagonal of
/// the box of meshes and tips. 0 when there is nothing.
[[nodiscard]] double reach_mm(const Toolpath& path, const Scene& scene);

}  // namespace gouge
