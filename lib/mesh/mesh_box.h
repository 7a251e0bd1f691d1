#pragma once

#include <span>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// The box of all meshes together; empty where none has a vertex.
[[nodiscard]] inline Box3 box_of(std::span<const IndexedMesh> meshes) {
  Box3 all;
  for (const IndexedMesh& mesh : meshes) all.extend(mesh.box());
  return all;
}

}  // namespace gouge
