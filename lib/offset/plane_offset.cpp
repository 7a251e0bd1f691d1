#include "lib/offset/plane_offset.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gouge {
namespace {

constexpr double kSameNormal = 1e-9;
// Squared sines of the angles between nearly equal normals are the smallest eigenvalues that mean something.
constexpr double kNoSpread = 1e-14;
constexpr double kMeets = 1e-9;

}  // namespace

std::vector<Vec3> distinct_normals(std::span<const Vec3> normals) {
  std::vector<Vec3> kept;
  for (const Vec3& n : normals) {
    bool is_new = true;
    for (const Vec3& known : kept) is_new = is_new && (known - n).cwiseAbs().maxCoeff() > kSameNormal;
    if (is_new) kept.push_back(n);
  }
  return kept;
}

PlaneOffset offset_of_planes(std::span<const Vec3> normals) {
  const std::vector<Vec3> planes = distinct_normals(normals);
  PlaneOffset result;
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
    if (eigen.eigenvalues()[i] <= kNoSpread * eigen.eigenvalues()[2]) continue;
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
  result.planes = miss > kMeets ? PlaneCase::many_planes : rank == 2 ? PlaneCase::two_planes : PlaneCase::three_planes;
  return result;
}

}  // namespace gouge
