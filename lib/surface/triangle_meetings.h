#pragma once

#include <cstdint>
#include <vector>

#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// Two triangles of a mesh that share more than a corner, an edge with both its ends, or a point.
struct TriangleMeeting {
  std::uint32_t a = 0, b = 0;                   ///< a < b
  bool is_coplanar = false;                     ///< true: they overlap in one plane; false: they meet along a segment
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< the ends of the segment, mm
};

/// Returns the length in mm below which points of a mesh cannot be distinguished. It covers the rounding of the mesh's
/// coordinates and of a few products.
[[nodiscard]] double rounding_of(const IndexedMesh& mesh);

/// Width of a triangle compared with rounding.
enum class TriangleWidth : std::uint8_t {
  wide,
  slim,  ///< rounding turns its plane by more than a few times its width. Crossings of two slim triangles may be missed
  none   ///< it has no area up to rounding, and meets nothing
};

[[nodiscard]] TriangleWidth width_of(const IndexedMesh& mesh, std::uint32_t triangle, double rounding_mm);

/// Finds all pairs of triangles that meet, in the order of the tree's leaves. Triangles without area, up to rounding, meet
/// nothing.
///
/// Requires a tree of one mesh.
/// Ensures  Each pair that crosses, overlaps in a plane or touches along a segment by more than rounding is found, except
///          for two slim triangles. The pairs are the same at any number of threads (0: all).
/// Cost     About half a microsecond for each triangle if none meet.
[[nodiscard]] std::vector<TriangleMeeting> find_triangle_meetings(const BlockTree& tree, unsigned threads = 0);

}  // namespace gouge
