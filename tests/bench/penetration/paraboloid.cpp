#include "tests/bench/penetration/paraboloid.h"

#include <Eigen/QR>
#include <algorithm>

namespace gouge {

Vec3 paraboloid_normal(const Vec3& vertex, std::span<const Vec3> neighbours, const Vec3& guess) {
  double scale = 0;
  for (const Vec3& p : neighbours) scale = std::max(scale, (p - vertex).norm());
  if (neighbours.size() < 3 || !(scale > 0)) return guess;
  const Vec3 u = guess.unitOrthogonal(), v = guess.cross(u);
  const auto rows = static_cast<Eigen::Index>(neighbours.size());
  Eigen::Matrix<double, Eigen::Dynamic, 5> terms(rows, 5);
  Eigen::VectorXd heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec3 d = (neighbours[static_cast<std::size_t>(i)] - vertex) / scale;
    const double x = u.dot(d), y = v.dot(d);
    terms.row(i) << x, y, x * x, x * y, y * y;
    heights[i] = guess.dot(d);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, Eigen::Dynamic, 5>> solver;
  solver.setThreshold(1e-8);
  solver.compute(terms);
  const Eigen::VectorXd fit = solver.solve(heights);
  const Vec3 normal = guess - fit[0] * u - fit[1] * v;
  return normal.normalized();
}

}  // namespace gouge
