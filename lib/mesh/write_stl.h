#pragma once

#include <string>

#include "lib/base/units.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Returns the mesh as binary STL in `unit`, with computed normals. Coordinates become single precision, as the format
/// requires. So triangles that were read from a binary STL (without a placement) are restored bit for bit. Requires
/// fewer than 2^32 triangles.
[[nodiscard]] std::string binary_stl_bytes(const IndexedMesh& mesh, LengthUnit unit);

}  // namespace gouge
