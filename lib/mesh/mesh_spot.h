#pragma once

#include <cstddef>

#include "lib/geom/vec.h"

namespace gouge {

/// How often something was found in a mesh, and where the first one is.
struct MeshSpot {
  std::size_t count = 0;
  Vec3 position_mm = Vec3::Zero();  ///< of the first: an edge's mid point, a triangle's centre, or the vertex;
                                    ///< part coordinates; meaningful when count > 0
  std::size_t file_triangle = 0;    ///< of the first: (one of) its triangle(s), index in the file from 0

  void add(const Vec3& point, std::size_t triangle) {
    if (count++ == 0) {
      position_mm = point;
      file_triangle = triangle;
    }
  }
};

}  // namespace gouge
