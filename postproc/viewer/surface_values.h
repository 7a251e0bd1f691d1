#pragma once

#include <vector>

#include "postproc/image/report_scene.h"

namespace gouge {

/// A point of the surface that needs a colour.
struct SurfacePoint {
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< outward unit vector
  std::size_t mesh = 0;         ///< index among the parts, then the fixtures
};

/// Quantity at a point: that of the pictures, the depth, or only the overcut (0 if it is unknown).
enum class SurfaceQuantity : std::uint8_t { pictured, depth, overcut };

/// The coloured quantity in the pictures of one path, at any point: the overcut, or the depth if no move has an
/// overcut.
class SurfaceValues {
 public:
  /// `path`, and the objects to which it points, must outlive it.
  explicit SurfaceValues(const PicturedPath& path) : path_(path) {}

  [[nodiscard]] bool is_overcut() const { return !path_.overcuts.is_empty(); }
  [[nodiscard]] bool is_empty() const { return path_.depths.is_empty(); }
  /// Returns values in mm; 0 where there is no gouge. It is fast for any order of the points.
  [[nodiscard]] std::vector<float> at(const std::vector<SurfacePoint>& points,
                                      SurfaceQuantity quantity = SurfaceQuantity::pictured) const;

 private:
  void drop_untouched(const std::vector<SurfacePoint>& points, std::vector<std::uint32_t>& order) const;

  const PicturedPath& path_;
};

}  // namespace gouge
