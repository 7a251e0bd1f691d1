#include "lib/offset/vertex_offsets.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {
namespace {

// Smallest significant eigenvalue: the squared sine of the angle between nearly equal normals.

}  // namespace

std::vector<Vec3> distinct_normals(std::span<const Vec3> normals) {
  std::vector<Vec3> kept;
  for (const Vec3& n : normals) {
    bool is_new = true;
    for (const Vec3& known : kept) is_new = is_new && (known - n).cwiseAbs().maxCoeff() > Tolerance::kSameDirection;
    if (is_new) kept.push_back(n);
  }
  return kept;
}

VertexOffset offset_of_planes(std::span<const Vec3> normals) {
  const std::vector<Vec3> planes = distinct_normals(normals);
  VertexOffset result;
  if (planes.empty()) return result;
  if (planes.size() == 1) return {planes[0], PlaneCase::one_plane};
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vec3 sum = Vec3::Zero();
  for (const Vec3& n : planes) {
    spread += n * n.transpose();
    sum += n;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
  int rank = 0;
  for (int i = 0; i < 3; ++i) {
    if (eigen.eigenvalues()[i] <= Tolerance::kSingular * eigen.eigenvalues()[2]) continue;
    const Vec3 axis = eigen.eigenvectors().col(i);
    result.move += axis * (axis.dot(sum) / eigen.eigenvalues()[i]);
    ++rank;
  }
  double miss = 0;
  for (const Vec3& n : planes) miss = std::max(miss, std::abs(n.dot(result.move) - 1));
  const double length = result.move.norm();
  if (length > kLongestOffset || !(length > 0.5)) {
    const Vec3 direction = length > 0 ? Vec3(result.move / length) : planes[0].unitOrthogonal();
    return {kLongestOffset * direction, PlaneCase::knife};
  }
  result.planes = miss > Tolerance::kRounding ? PlaneCase::many_planes
                  : rank == 2                 ? PlaneCase::two_planes
                                              : PlaneCase::three_planes;
  return result;
}

std::vector<Vec3> face_normals(const IndexedMesh& mesh) {
  std::vector<Vec3> normals(mesh.triangles.size(), Vec3::Zero());
  for (std::size_t t = 0; t < normals.size(); ++t) normals[t] = face_normal(mesh, t);
  return normals;
}

Vec3 angle_weighted_normal(const IndexedMesh& mesh, const MeshAdjacency& adjacency, const std::vector<Vec3>& normals,
                           Corner vertex) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t t : adjacency.triangles_of_vertex(vertex)) sum += angle_at(mesh, t, vertex) * normals[t];
  const double length = sum.norm();
  return length > Tolerance::kNoDirection ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

std::vector<VertexOffset> offset_by_planes(const IndexedMesh& mesh, const MeshAdjacency& adjacency) {
  const std::vector<Vec3> normals = face_normals(mesh);
  std::vector<VertexOffset> all;
  all.reserve(mesh.vertices.size());
  std::vector<Vec3> faces;
  for (Corner v = 0; v < mesh.vertices.size(); ++v) {
    faces.clear();
    for (const std::uint32_t t : adjacency.triangles_of_vertex(v)) {
      if (normals[t].squaredNorm() > 0) faces.push_back(normals[t]);
    }
    all.push_back(offset_of_planes(faces));
  }
  return all;
}

}  // namespace gouge
