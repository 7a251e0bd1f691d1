#pragma once

#include <cstddef>
#include <string>

#include "lib/base/diagnostic.h"
#include "lib/geom/vec.h"
#include "lib/mesh/triangle_list.h"

// What an STL file holds: triangles that do not know each other (thesis 4.1.1).

namespace gouge {

enum class StlFormat { binary, ascii };

struct TriangleSoup {
  std::string name;  ///< as the user named the file
  StlFormat format = StlFormat::binary;
  TriangleList triangles;  ///< file coordinates and file units; finite
  /// Stored normals that point to the other side of their triangle. They are never used for orientation.
  std::size_t opposite_normals = 0;
  std::size_t first_opposite_normal = 0;  ///< index of the first of them; 0 when there is none
  Diagnostics notes;                      ///< oddities that were tolerated
};

}  // namespace gouge
