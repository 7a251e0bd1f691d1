#pragma once

#include <cmath>

#include "lib/geom/point_triangle.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

struct BruteClosestPoint {
  Vec3 point = Vec3::Zero();
  double distance_mm = 0;
};

/// The slow, obvious reference: the nearest point over all triangles, no tree, no volumes, no planes.
inline BruteClosestPoint brute_force_closest_point(const IndexedMesh& mesh, const Vec3& point) {
  BruteClosestPoint best;
  double best2 = -1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TrianglePoint foot = closest_on_triangle(point, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    if (best2 >= 0 && foot.distance2_mm2 >= best2) continue;
    best2 = foot.distance2_mm2;
    best.point = foot.point;
  }
  best.distance_mm = std::sqrt(best2);
  return best;
}

}  // namespace gouge
