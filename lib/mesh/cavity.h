#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Cavities that can be proved: a shell that faces inward and stands alone in solid material.
class Cavities {
 public:
  /// Requires that every edge of the mesh runs equally often both ways; the mesh must outlive it. Cost O(n).
  explicit Cavities(const IndexedMesh& mesh);

  /// Whether the point is in a cavity. True only when one shell of two triangles an edge winds about it inward, the
  /// others about it once outward, and none of those that have the point in their box comes near the shell's, so that
  /// the shell is cut out of material. Cost O(n).
  [[nodiscard]] bool contain(const Vec3& point) const;

 private:
  struct Shell {
    Box3 box;
    bool is_manifold = true;  ///< two triangles at every edge
  };
  [[nodiscard]] bool stands_alone(std::uint32_t shell, const Vec3& point) const;

  const IndexedMesh& mesh_;
  std::vector<std::uint32_t> shell_of_;  // per triangle
  std::vector<Shell> shells_;
};

}  // namespace gouge
