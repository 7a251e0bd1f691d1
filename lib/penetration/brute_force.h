#pragma once

#include "lib/mesh/indexed_mesh.h"
#include "lib/penetration/surface_sign.h"

namespace gouge {

struct BruteFoot {
  Vec3 point = Vec3::Zero();
  double distance_mm = 0;
};

/// The slow, obvious reference: the nearest point over all triangles, no tree, no volumes, no planes.
[[nodiscard]] BruteFoot brute_force_foot(const IndexedMesh& mesh, const Vec3& point);

}  // namespace gouge
