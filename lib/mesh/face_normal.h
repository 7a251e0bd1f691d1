#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// Unit normal of a triangle, outward of a closed mesh; zero for one without area.
[[nodiscard]] inline Vec3 face_normal(const IndexedMesh& mesh, std::size_t triangle) {
  const Vec3 across =
      (mesh.corner(triangle, 1) - mesh.corner(triangle, 0)).cross(mesh.corner(triangle, 2) - mesh.corner(triangle, 0));
  const double length = across.norm();
  return length > 0 ? Vec3(across / length) : Vec3(Vec3::Zero());
}

/// The angle between the two edges of a triangle that meet at `vertex`, one of its corners.
[[nodiscard]] inline double angle_at(const IndexedMesh& mesh, std::size_t triangle, Corner vertex) {
  const TriangleCorners& c = mesh.triangles[triangle];
  const std::size_t k = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
  const Vec3 a = mesh.corner(triangle, (k + 1) % 3) - mesh.vertices[vertex];
  const Vec3 b = mesh.corner(triangle, (k + 2) % 3) - mesh.vertices[vertex];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace gouge
