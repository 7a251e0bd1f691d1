#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "lib/geom/point_triangle.h"
#include "lib/geom/vec.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/vertex_triangles.h"

namespace gouge {

/// The point of a surface that is nearest to a given point.
struct ClosestPoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal =
      Vec3::UnitZ();           ///< unit; out of the body: along the line to or from the point, the facet's normal on it
  double distance_mm = 0;      ///< never negative
  bool is_inside = false;      ///< the queried point lies in the solid; always false if the surface is no solid
  std::uint32_t triangle = 0;  ///< index in the mesh

  /// Returns the signed distance, negative inside.
  [[nodiscard]] double signed_mm() const { return is_inside ? -distance_mm : distance_mm; }
};

/// A mesh with its index and the data for the side of a point. Each is made once, at the first request. The object is
/// small and shared by its copies. Any number of threads may call it.
class Surface {
 public:
  /// Refers to a mesh, which must outlive all copies. `threads` has the meaning of build_block_tree.
  explicit Surface(const IndexedMesh& mesh, unsigned threads = 0);
  /// Takes ownership of the mesh.
  explicit Surface(IndexedMesh&& mesh);
  /// Refers to a mesh and to `tree`, the tree of that mesh alone. Both must outlive all copies.
  Surface(const IndexedMesh& mesh, const BlockTree& tree);

  [[nodiscard]] const IndexedMesh& mesh() const;
  [[nodiscard]] const BlockTree& tree() const;
  /// Returns the triangles at each vertex, which take 14 bytes for each triangle. The first call costs O(n).
  [[nodiscard]] const VertexTriangles& triangles_at_vertices() const;
  /// Returns whether the surface is closed, oriented and outward, so that it has an inside. The first call costs O(n).
  [[nodiscard]] bool is_solid() const;

  /// Returns the boundary of the solid. That is the surface itself or, if shells nest, overlap or cross, the part with
  /// no material on one side (solid_boundary.h). Only this boundary gives the side of a point of a solid, or a depth in
  /// it. For a surface that is not a solid it is the surface itself. If the surface encloses no volume, or if some of
  /// its sides are unknown because of rounding, the boundary has all its triangles and is no solid.
  /// Ensures  The result is valid as long as this surface or a copy of it. The first call costs the same as
  ///          find_solid_boundary.
  [[nodiscard]] const Surface& boundary() const;
  /// Returns whether the boundary is the surface itself.
  [[nodiscard]] bool is_boundary() const { return &boundary() == this; }

  [[nodiscard]] std::array<Vec3, 3> corners(std::size_t triangle) const {
    return {mesh().corner(triangle, 0), mesh().corner(triangle, 1), mesh().corner(triangle, 2)};
  }
  /// Returns the unit normal of a triangle; zero for a triangle without area.
  [[nodiscard]] Vec3 face_normal(std::size_t triangle) const { return gouge::face_normal(mesh(), triangle); }

  /// Returns the closest point within `within_mm`; nothing if there is none, or no triangle at all.
  ///
  /// Ensures  The result is exact at any distance, on both sides of a solid. Of equally near triangles it has the
  ///          lowest (closest_triangle.h). Without a solid every point counts as outside.
  /// Requires for is_inside: a surface that is the boundary of its body (boundary()).
  /// Cost     About O(log n).
  [[nodiscard]] std::optional<ClosestPoint> closest_point(
      const Vec3& point, double within_mm = std::numeric_limits<double>::infinity()) const;

  /// Returns the same without a limit. The search starts from triangle `near`, which is faster if that is about as near
  /// as the closest. Requires a mesh with triangles.
  [[nodiscard]] ClosestPoint closest_point_from(const Vec3& point, std::uint32_t near) const;

  /// Returns whether a point off the surface lies in the solid, from how often all triangles wind around it. Requires
  /// is_solid().
  /// Cost     About O(log n); O(n) if several rays meet edges.
  [[nodiscard]] bool winds_around(const Vec3& point) const;

  /// Returns the closest point, with the side, for a known nearest triangle and its foot.
  [[nodiscard]] ClosestPoint signed_closest_point(const Vec3& point, std::uint32_t triangle,
                                                  const TrianglePoint& foot) const;

 private:
  struct Shared;
  [[nodiscard]] Vec3 outward_at(std::uint32_t triangle, const TrianglePoint& foot) const;
  explicit Surface(std::shared_ptr<const Shared> shared) : shared_(std::move(shared)) {}
  std::shared_ptr<const Shared> shared_;
};

}  // namespace gouge
