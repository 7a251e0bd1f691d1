#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/geom/vec.h"

// The indexed mesh of thesis 4.2: every vertex once, triangles as indices. It is exactly the surface of the file:
// welding joins only identical coordinates.

namespace gouge {

using Corner = std::uint32_t;
using TriangleCorners = std::array<Corner, 3>;

struct IndexedMesh {
  std::string name;                          ///< as the user named the file
  std::vector<Vec3> vertices;                ///< mm, part coordinates
  std::vector<TriangleCorners> triangles;    ///< counter-clockwise seen from outside
  std::vector<std::uint32_t> file_triangle;  ///< for each triangle: its index in the file, ascending (dropped triangles
                                             ///< leave gaps)

  [[nodiscard]] const Vec3& corner(std::size_t triangle, std::size_t k) const {
    return vertices[triangles[triangle][k]];
  }
  [[nodiscard]] Box3 box() const {
    Box3 all;
    for (const Vec3& v : vertices) all.extend(v);
    return all;
  }
};

/// Returns the box of all meshes together; empty if no mesh has a vertex.
[[nodiscard]] inline Box3 box_of(std::span<const IndexedMesh> meshes) {
  Box3 all;
  for (const IndexedMesh& mesh : meshes) all.extend(mesh.box());
  return all;
}

[[nodiscard]] inline Box3 box_of(const IndexedMesh& mesh, std::size_t triangle) {
  Box3 box(mesh.corner(triangle, 0));
  box.extend(mesh.corner(triangle, 1));
  box.extend(mesh.corner(triangle, 2));
  return box;
}

/// Returns the unit normal of a triangle, which is outward for a closed mesh; zero for a triangle without area.
[[nodiscard]] inline Vec3 face_normal(const IndexedMesh& mesh, std::size_t triangle) {
  const Vec3 across =
      (mesh.corner(triangle, 1) - mesh.corner(triangle, 0)).cross(mesh.corner(triangle, 2) - mesh.corner(triangle, 0));
  const double length = across.norm();
  return length > 0 ? Vec3(across / length) : Vec3(Vec3::Zero());
}

/// Returns the angle between the two edges of a triangle that meet at `vertex`, one of its corners.
[[nodiscard]] inline double angle_at(const IndexedMesh& mesh, std::size_t triangle, Corner vertex) {
  const TriangleCorners& c = mesh.triangles[triangle];
  const std::size_t k = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
  const Vec3 a = mesh.corner(triangle, (k + 1) % 3) - mesh.vertices[vertex];
  const Vec3 b = mesh.corner(triangle, (k + 2) % 3) - mesh.vertices[vertex];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace gouge
