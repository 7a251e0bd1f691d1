#pragma once

#include <cstddef>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/base/units.h"
#include "lib/geom/pose.h"
#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/triangle_soup.h"

// Triangle soup to indexed mesh (thesis 4.1.1, 4.2): one vertex for all corners with identical coordinates.
// Corners that are merely near each other stay apart; the surface is exactly that of the file.

namespace gouge {

/// Count of something found in a mesh, and the place of the first.
struct MeshSpot {
  std::size_t count = 0;
  Vec3 position_mm = Vec3::Zero();  ///< of the first: an edge's mid point, a triangle's centre, or the vertex;
                                    ///< part coordinates; meaningful when count > 0
  std::size_t file_triangle = 0;    ///< of the first: (one of) its triangle(s), index in the file from 0

  void add(const Vec3& point, std::size_t triangle) {
    if (count++ == 0) {
      position_mm = point;
      file_triangle = triangle;
    }
  }
};

/// Transform of a body's file coordinates to part coordinates: scaled to mm first, then placed.
struct MeshPlacement {
  LengthUnit unit = LengthUnit::mm;
  RigidTransform transform;
};

struct BuiltMesh {
  IndexedMesh mesh;
  /// Triangles with two identical corners: left out of the mesh (they are a line, which their neighbours
  /// have).
  MeshSpot degenerate;
  /// Triangles whose three distinct corners lie on one line. They are kept, since the check is about every point of the
  /// surface. In an open mesh a neighbour need not have theirs.
  MeshSpot collinear;
  /// Triangles whose stored normal points to their other side (see TriangleSoup).
  MeshSpot opposite_normals;
};

/// Welds, scales and places. Vertices stand in the order of their first appearance, triangles in file order;
/// -0 and +0 are the same coordinate. Duplicated triangles stay.
///
/// Errors   stl-no-surface: every triangle is degenerate. stl-coordinate-too-large: a coordinate beyond
///          1e9 mm after scaling.
/// Cost     O(n).
[[nodiscard]] Result<BuiltMesh> build_mesh(const TriangleSoup& soup, const MeshPlacement& placement = {},
                                           const ProgressCall& progress = {});

}  // namespace gouge
