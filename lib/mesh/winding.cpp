#include "lib/mesh/winding.h"

#include <cmath>
#include <numbers>

namespace gouge {

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 pa = a - point;
  const Vec3 pb = b - point;
  const Vec3 pc = c - point;
  const double la = pa.norm();
  const double lb = pb.norm();
  const double lc = pc.norm();
  const double volume = pa.dot(pb.cross(pc));
  const double across = la * lb * lc + pa.dot(pb) * lc + pb.dot(pc) * la + pc.dot(pa) * lb;
  return 2 * std::atan2(volume, across);
}

double winding_number(const IndexedMesh& mesh, const Vec3& point_part) {
  double sum = 0;
  for (const TriangleCorners& t : mesh.triangles) {
    sum += solid_angle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], point_part);
  }
  return sum / (4 * std::numbers::pi);
}

bool is_inside(std::span<const IndexedMesh> meshes, const Vec3& point_part) {
  double winding = 0;
  for (const IndexedMesh& mesh : meshes) winding += winding_number(mesh, point_part);
  return std::abs(winding) > 0.5;
}

}  // namespace gouge
