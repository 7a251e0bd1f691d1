#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Cavities that can be proved: a shell that faces inward and stands alone in solid material.
class Cavities {
 public:
  /// `file_of`: per triangle, the file it comes from; empty: all from one.
  /// Requires that every edge of the mesh runs equally often both ways; the mesh must outlive it. Cost O(n).
  explicit Cavities(const IndexedMesh& mesh, std::span<const std::uint32_t> file_of = {});

  /// Whether the point is in a cavity. True only when one shell of two triangles an edge winds about it inward, others
  /// of the same file about it once outward, those of other files not at all, and none of those that have the point in
  /// their box comes near the shell's, so that the shell is cut out of material. Cost O(n).
  [[nodiscard]] bool contain(const Vec3& point) const;

 private:
  struct Shell {
    Box3 box;
    bool is_manifold = true;  ///< two triangles at every edge
    std::uint32_t file = 0;
    bool is_of_one_file = true;
  };
  [[nodiscard]] bool stands_alone(std::uint32_t shell, const Vec3& point) const;

  const IndexedMesh& mesh_;
  std::vector<std::uint32_t> shell_of_;  // per triangle
  std::vector<Shell> shells_;
};

}  // namespace gouge
