#pragma once

#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// What stands still: parts and fixtures, in mm and part coordinates.
struct Scene {
  std::vector<IndexedMesh> parts;
  std::vector<IndexedMesh> fixtures;
};

}  // namespace gouge
