#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

// Where a surface, of one file or of several together, does not close or contradicts its own orientation.

namespace gouge {

/// The triangles of several files as one surface.
struct WeldedMesh {
  IndexedMesh mesh;                    ///< without name and file_triangle
  std::vector<std::uint32_t> file_of;  ///< per triangle: the number of its mesh
  std::size_t repeated = 0;            ///< triangles left out
};

/// Returns triangles of several meshes over one list of vertices: identical coordinates are one vertex, whatever file
/// they come from. Of triangles with the same corners and the same orientation only the first is kept.
/// Cost     O(n log n).
[[nodiscard]] WeldedMesh weld_together(std::span<const IndexedMesh> meshes);

/// An edge that is not used equally often in both directions.
struct FaultyEdge {
  Corner from = 0, to = 0;
  int surplus = 0;  ///< uses from -> to less uses to -> from; above 0
};

/// Faulty edges that hang together. Their sum is a cycle, so it can be filled: to one point, for example.
struct SurfaceGap {
  std::vector<FaultyEdge> edges;
  /// The rim runs along this segment and leaves it by no more than `width_mm`.
  Vec3 end_a = Vec3::Zero(), end_b = Vec3::Zero();
  double width_mm = 0;

  /// Returns the distance of a point from the segment.
  [[nodiscard]] double distance_mm(const Vec3& point) const;
};

struct EdgeFaults {
  std::size_t open = 0;          ///< edges with an odd number of triangles: a hole's rim
  std::size_t misoriented = 0;   ///< edges with an even number that do not run equally often both ways
  std::vector<SurfaceGap> gaps;  ///< of both kinds, in the order of their lowest vertices
  [[nodiscard]] bool is_empty() const { return gaps.empty(); }
};

/// Requires triangles with three distinct corners.
/// Cost     O(n).
[[nodiscard]] EdgeFaults find_edge_faults(const IndexedMesh& mesh);

}  // namespace gouge
