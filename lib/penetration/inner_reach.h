#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// How far the inside points reach that are nearest to a facet: what a volume must hold so that none of them
/// within a depth is missed. They lie below the face, in the wedge at a reflex edge, or in the cone at a
/// vertex that is not convex. Proof: docs/algorithms/shallow_penetration.md, section 4.
class InnerReach {
 public:
  InnerReach(const IndexedMesh& mesh, const MeshAdjacency& adjacency, const std::vector<Vec3>& face_normals);

  /// Not below the largest u . x over the inside points x that are nearest to `triangle` and within
  /// `depth_mm` of it, the facet itself included. `u` unit.
  [[nodiscard]] double above(std::uint32_t triangle, const Vec3& u, double depth_mm) const;

 private:
  /// The directions from a vertex to the inside points nearest to it: within an angle of `axis`.
  struct Cone {
    Vec3 axis = Vec3::Zero();
    double cosine = 2;  ///< above 1: there are none; -1: all directions
  };

  [[nodiscard]] Cone cone_at(Corner vertex, const MeshAdjacency& adjacency) const;
  void find_wedges(const MeshAdjacency& adjacency);

  const IndexedMesh& mesh_;
  const std::vector<Vec3>& normals_;
  std::vector<Cone> cones_;                  ///< by vertex
  std::vector<std::array<Cone, 3>> wedges_;  ///< by triangle, edge
};

}  // namespace gouge
