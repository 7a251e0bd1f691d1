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

[[nodiscard]] inline Box3 box_of(const IndexedMesh& mesh, std::size_t triangle) {
  Box3 box(mesh.corner(triangle, 0));
  box.extend(mesh.corner(triangle, 1));
  box.extend(mesh.corner(triangle, 2));
  return box;
}

}  // namespace gouge
