#pragma once

#include <vector>

#include <gougecheck/mesh.h>

namespace gougecheck {

/// From (0, 0, -10) to (40, 20, 0): its top is the plane z = 0.
inline Mesh block(double lift = 0) {
  std::vector<Vec3> corners;
  for (const double z : {lift - 10, lift})
    corners.insert(corners.end(), {{0, 0, z}, {40, 0, z}, {40, 20, z}, {0, 20, z}});
  const std::vector<Triangle> faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                       {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return {corners, faces, "block"};
}

inline const std::vector<Vec3> kUp = {{0, 0, 1}};

}  // namespace gougecheck
