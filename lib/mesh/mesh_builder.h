#pragma once

#include <cstddef>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/base/units.h"
#include "lib/geom/pose.h"
#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/triangle_soup.h"

// Converts a triangle soup to an indexed mesh (thesis 4.1.1, 4.2), with one vertex for all corners with identical
// coordinates. Corners that are only near each other stay apart, so the surface is exactly that of the file.

namespace gouge {

/// Number of faults of one kind in a mesh, and the place of the first.
struct MeshSpot {
  std::size_t count = 0;
  Vec3 position_mm = Vec3::Zero();  ///< place of the first: an edge's mid point, a triangle's centre, or the vertex;
                                    ///< part coordinates; valid if count > 0
  std::size_t file_triangle = 0;    ///< a triangle of the first: index in the file from 0

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
  /// Triangles with two identical corners. They are left out of the mesh: each is only a line, which its neighbours
  /// contain.
  MeshSpot degenerate;
  /// Triangles whose three distinct corners lie on one line. They are kept, because the check is about every point of
  /// the surface. In an open mesh, neighbours need not contain their points.
  MeshSpot collinear;
  /// Triangles whose stored normal points to their other side (see TriangleSoup).
  MeshSpot opposite_normals;
};

/// Welds, scales and places a surface. Vertices are in the order of their first appearance, triangles in file order. -0
/// and +0 are the same coordinate. Duplicated triangles stay.
///
/// Errors   stl-no-surface: every triangle is degenerate. stl-coordinate-too-large: a coordinate is beyond 1e9 mm after
///          scaling.
/// Cost     O(n).
[[nodiscard]] Result<BuiltMesh> build_mesh(const TriangleSoup& soup, const MeshPlacement& placement = {},
                                           const ProgressCall& progress = {});

}  // namespace gouge
