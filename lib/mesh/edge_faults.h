#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/mesh/indexed_mesh.h"

// Places where a surface, of one file or of several together, is not closed or contradicts its own orientation.

namespace gouge {

/// The triangles of several files as one surface.
struct WeldedMesh {
  IndexedMesh mesh;                    ///< the name and file_triangle are empty
  std::vector<std::uint32_t> file_of;  ///< for each triangle: the index of its mesh
  std::size_t repeated = 0;            ///< number of triangles that were left out
};

/// Returns the triangles of several meshes over one list of vertices. Identical coordinates are one vertex, whatever
/// file they come from. Of triangles with the same corners and the same orientation, only the first is kept.
/// Cost     O(n log n).
[[nodiscard]] WeldedMesh weld_together(std::span<const IndexedMesh> meshes);

/// An edge that is not used equally often in both directions.
struct FaultyEdge {
  Corner from = 0, to = 0;
  int surplus = 0;  ///< number of uses from -> to minus uses to -> from; above 0
};

/// Connected faulty edges. Their sum is a cycle, so the gap can be filled, for example by triangles to one point.
struct SurfaceGap {
  std::vector<FaultyEdge> edges;
  /// The rim runs along this segment and deviates from it by at most `width_mm`.
  Vec3 end_a = Vec3::Zero(), end_b = Vec3::Zero();
  double width_mm = 0;

  /// Returns the distance of a point from the segment.
  [[nodiscard]] double distance_mm(const Vec3& point) const;
};

struct EdgeFaults {
  std::size_t open = 0;          ///< number of edges with an odd number of triangles: the rim of a hole
  std::size_t misoriented = 0;   ///< number of edges with an even number of triangles that do not run equally often
                                 ///< both ways
  std::vector<SurfaceGap> gaps;  ///< gaps of both kinds, in the order of their lowest vertices
  [[nodiscard]] bool is_empty() const { return gaps.empty(); }
};

/// Finds the faulty edges and gaps. Requires triangles with three distinct corners.
/// Cost     O(n).
[[nodiscard]] EdgeFaults find_edge_faults(const IndexedMesh& mesh);

}  // namespace gouge
