#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/geom/rigid_transform.h"
#include "lib/geom/vec.h"

// The indexed mesh of thesis 4.2: every vertex once, triangles as indices. Exactly the surface of the file:
// welding joins identical coordinates and nothing else.

namespace gouge {

using Corner = std::uint32_t;
using TriangleCorners = std::array<Corner, 3>;

struct IndexedMesh {
  std::string name;                          ///< as the user named the file
  std::vector<Vec3> vertices;                ///< mm, part coordinates
  std::vector<TriangleCorners> triangles;    ///< counter-clockwise seen from outside
  std::vector<std::uint32_t> file_triangle;  ///< per triangle: its index in the file (dropped ones leave gaps)

  [[nodiscard]] const Vec3& corner(std::size_t triangle, std::size_t k) const {
    return vertices[triangles[triangle][k]];
  }
  [[nodiscard]] Box3 box() const {
    Box3 all;
    for (const Vec3& v : vertices) all.extend(v);
    return all;
  }
};

}  // namespace gouge
