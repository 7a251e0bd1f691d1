#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Depth of points in a body given as a closed mesh: the distance to the surface where the winding number becomes 0.
/// Nested, overlapping and crossing shells are one body. It computes winding numbers over all triangles, without a
/// tree.
class SolidDepth {
 public:
  /// The mesh must outlive the object. Cost O(n log n), plus the pairs of triangles whose boxes intersect.
  explicit SolidDepth(const IndexedMesh& mesh);

  [[nodiscard]] const IndexedMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const Box3& box() const { return box_; }
  /// Returns the depth at a point; 0 outside. Cost O(n), and O(n) for each crossing of triangles near the point.
  [[nodiscard]] double at(const Vec3& point) const;
  /// Returns whether the winding number at a point is 0. Cost O(n).
  [[nodiscard]] bool is_outside(const Vec3& point) const;
  /// Returns the distance to the nearest triangle. Cost O(n).
  [[nodiscard]] double distance_to_surface(const Vec3& point) const;

 private:
  using Segment = std::array<Vec3, 2>;

  void find_crossings();
  void add_crossing(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] bool has_outside_beside(std::uint32_t triangle, const Vec3& point) const;
  [[nodiscard]] bool has_outside_around(std::uint32_t triangle, const Vec3& point) const;
  [[nodiscard]] double nearest_on_crossed(std::uint32_t triangle, const Vec3& point, double below_mm) const;
  [[nodiscard]] std::vector<Vec3> places_on(std::uint32_t triangle, const Vec3& point) const;
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const {
    return {mesh_->corner(triangle, 0), mesh_->corner(triangle, 1), mesh_->corner(triangle, 2)};
  }

  const IndexedMesh* mesh_;
  Box3 box_;
  std::vector<std::vector<Segment>> crossings_;  // by triangle: the segments where it meets others
};

}  // namespace gouge
