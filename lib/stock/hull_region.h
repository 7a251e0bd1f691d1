#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "lib/geom/half_space.h"
#include "lib/geom/vec.h"

namespace gouge {

/// A box along the axes, or a tetrahedron: the hull of up to eight points. mm, part coordinates.
struct HullRegion {
  static constexpr std::size_t kMaxPoints = 8, kMaxFaces = 4;
  std::array<Vec3, kMaxPoints> corners;
  std::size_t count = 0;
  std::array<HalfSpace, kMaxFaces> faces;  ///< half-spaces that contain it, besides those of its box
  std::size_t face_count = 0;

  [[nodiscard]] static HullRegion box(const Vec3& low, const Vec3& high) {
    HullRegion region;
    for (std::size_t k = 0; k < kMaxPoints; ++k)
      region.corners[k] = Vec3((k & 1U) != 0 ? high.x() : low.x(), (k & 2U) != 0 ? high.y() : low.y(),
                               (k & 4U) != 0 ? high.z() : low.z());
    region.count = kMaxPoints;
    return region;
  }
  [[nodiscard]] static HullRegion tetrahedron(const std::array<Vec3, 4>& points) {
    HullRegion region;
    region.count = points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      region.corners[k] = points[k];
      const Vec3 &a = points[(k + 1) % 4], &b = points[(k + 2) % 4], &c = points[(k + 3) % 4];
      const Vec3 across = (b - a).cross(c - a);
      const double size = across.norm();
      if (!(size > 0)) continue;
      const Vec3 normal = across / size;
      const bool is_inward = normal.dot(points[k] - a) > 0;
      const Vec3 inward = is_inward ? normal : Vec3(-normal);
      double least = inward.dot(a);
      for (const Vec3& point : points) least = std::min(least, inward.dot(point));
      region.faces[region.face_count++] = {inward, least};
    }
    return region;
  }

  [[nodiscard]] std::span<const Vec3> points() const { return {corners.data(), count}; }
  [[nodiscard]] Vec3 middle() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& point : points()) sum += point;
    return sum / static_cast<double>(count);
  }
  /// Returns the radius of a ball about `center` that contains it.
  [[nodiscard]] double reach_mm(const Vec3& center) const {
    double square = 0;
    for (const Vec3& point : points()) square = std::max(square, (point - center).squaredNorm());
    return std::sqrt(square);
  }
  [[nodiscard]] Vec3 low() const {
    Vec3 least = corners[0];
    for (const Vec3& point : points()) least = least.cwiseMin(point);
    return least;
  }
  [[nodiscard]] Vec3 high() const {
    Vec3 most = corners[0];
    for (const Vec3& point : points()) most = most.cwiseMax(point);
    return most;
  }
};

}  // namespace gouge
