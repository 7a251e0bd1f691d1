#pragma once

#include <algorithm>
#include <array>

#include "lib/geom/vec.h"

namespace gouge {

/// The feature of a triangle on which a closest point lies.
enum class TriangleFeature { face, edge, corner };

struct TrianglePoint {
  Vec3 point = Vec3::Zero();
  double distance2_mm2 = 0;
  TriangleFeature feature = TriangleFeature::face;
  /// Edge: from corner `index` to the next one. Corner: that corner. Face: 0.
  std::size_t index = 0;
  double min_weight = 0;  ///< Face: the smallest barycentric coordinate of the foot; 0 elsewhere.
};

namespace detail {

inline TrianglePoint triangle_point(const Vec3& p, const Vec3& foot, TriangleFeature feature, std::size_t index) {
  return {foot, (p - foot).squaredNorm(), feature, index, 0};
}

/// Returns the closest point on the edge from corner `k` to the next one. An end of the edge counts as a corner.
inline TrianglePoint closest_on_edge(const Vec3& p, const std::array<Vec3, 3>& t, std::size_t k) {
  const std::size_t next = (k + 1) % 3;
  const Vec3 along = t[next] - t[k];
  const double length2 = along.squaredNorm(), projection = along.dot(p - t[k]);
  if (!(projection > 0)) return triangle_point(p, t[k], TriangleFeature::corner, k);
  if (projection >= length2) return triangle_point(p, t[next], TriangleFeature::corner, next);
  return triangle_point(p, t[k] + (projection / length2) * along, TriangleFeature::edge, k);
}

inline TrianglePoint closest_on_rim(const Vec3& p, const std::array<Vec3, 3>& t) {
  TrianglePoint best = closest_on_edge(p, t, 0);
  for (std::size_t k = 1; k < 3; ++k) {
    const TrianglePoint other = closest_on_edge(p, t, k);
    if (other.distance2_mm2 < best.distance2_mm2) best = other;
  }
  return best;
}

/// Returns whether the weights of a foot, computed from dot products, lose about half of their digits or more.
inline bool is_sliver(const Vec3& ab, const Vec3& ac) {
  // Limit of (width / length)^2. The error of the foot is then at most about eps * length / kSliver.
  constexpr double kSliver = 1e-4;
  const double ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm(), b = ab.dot(ac);
  const double length2 = std::max({ab2, ac2, ab2 + ac2 - 2 * b});
  return !(ab2 * ac2 - b * b > kSliver * length2 * length2);
}

/// Returns the closest point of a very narrow triangle. It measures along and across the longest edge. There the
/// rounding error is only a few units of the last place of the length.
inline TrianglePoint closest_on_sliver(const Vec3& p, const std::array<Vec3, 3>& t) {
  std::size_t k = 0;
  for (const std::size_t i : {1U, 2U}) {
    if ((t[(i + 1) % 3] - t[i]).squaredNorm() > (t[(k + 1) % 3] - t[k]).squaredNorm()) k = i;
  }
  const Vec3 along = t[(k + 1) % 3] - t[k], side = t[(k + 2) % 3] - t[k], q = p - t[k];
  const double length2 = along.squaredNorm();
  if (!(length2 > 0)) return triangle_point(p, t[0], TriangleFeature::corner, 0);
  Vec3 across = side - (side.dot(along) / length2) * along;
  across -= (across.dot(along) / length2) * along;  // remove the rest along the edge, which comes from rounding
  const double width2 = across.squaredNorm();
  if (!(width2 > 0)) return closest_on_rim(p, t);
  const double far = q.dot(across) / width2;  // weight of the corner opposite the edge
  const double position = q.dot(along) / length2;
  const double next = position - far * (side.dot(along) / length2);
  const double least = std::min({far, next, 1 - far - next});
  if (!(least > 0)) return closest_on_rim(p, t);
  TrianglePoint foot = triangle_point(p, t[k] + position * along + far * across, TriangleFeature::face, 0);
  foot.min_weight = least;
  return foot;
}

}  // namespace detail

/// Finds the closest point of triangle `t` to `p`, and the feature on which it lies.
///
/// Degenerate  A triangle without area counts as its edges, a triangle without extent as its first corner. Never NaN
///             for finite input.
/// Rounding    The distance is that of a point of the triangle. It exceeds the minimum by at most 1e-11 of the
///             differences of coordinates, even for very narrow triangles.
/// Cost        Constant, no allocation.
/// Source      C. Ericson, Real-Time Collision Detection (2005), 5.1.5: regions of the triangle by dot products. Very
///             narrow triangles use another method, because their weights would be mostly rounding errors.
[[nodiscard]] inline TrianglePoint closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& t) {
  using detail::triangle_point;
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return triangle_point(p, t[0], TriangleFeature::corner, 0);
  const Vec3 bp = p - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return triangle_point(p, t[1], TriangleFeature::corner, 1);
  const Vec3 cp = p - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return triangle_point(p, t[2], TriangleFeature::corner, 2);
  if (detail::is_sliver(ab, ac)) return detail::closest_on_sliver(p, t);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (va > 0 && vb > 0 && vc > 0) {
    const double scale = 1 / (va + vb + vc);
    TrianglePoint foot = triangle_point(p, t[0] + (vb * scale) * ab + (vc * scale) * ac, TriangleFeature::face, 0);
    foot.min_weight = scale * std::min({va, vb, vc});
    return foot;
  }
  return detail::closest_on_rim(p, t);
}

}  // namespace gouge
