#pragma once

#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Moves all positions, axes and curves of a path into other coordinates. The source text of the path stays as it is.
/// Requires a path without joints: they belong to one place of the path on the machine.
void place_path(const RigidTransform& place, Toolpath& path);

}  // namespace gouge
