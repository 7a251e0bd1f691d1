#pragma once

#include <span>
#include <vector>

#include "lib/base/result.h"
#include "lib/geom/vec.h"
#include "lib/stock/disc.h"
#include "lib/stock/hull_region.h"
#include "lib/stock/prism.h"
#include "lib/surface/surface.h"

namespace gouge {

/// The material at the start: a box, closed meshes, or the part with an allowance. mm, part coordinates.
class StockSolid {
 public:
  /// Requires low <= high in every coordinate.
  [[nodiscard]] static StockSolid box(const Vec3& low, const Vec3& high);
  /// Returns the union of the meshes, each moved out by `allowance_mm` >= 0 in all directions. The meshes must outlive the
  /// solid. Errors: a mesh is not closed, not oriented or has triangles that cross, so that it has no inside.
  [[nodiscard]] static Result<StockSolid> meshes(std::span<const IndexedMesh> meshes, double allowance_mm);

  /// Returns the inside of a closed surface that is the boundary of its solid. Its mesh must outlive the solid.
  [[nodiscard]] static StockSolid solid(const Surface& boundary);

  /// Returns whether the hull of the discs, moved out by `radius_mm`, is proved to have no point of the stock inside it.
  /// A negative radius leaves out stock that is nearer to its surface than that. False if it is not known.
  [[nodiscard]] bool is_clear_of(std::span<const Disc> discs, double radius_mm) const;
  /// Returns whether a ball about a point is in the material, at least a rounding from its boundary.
  [[nodiscard]] bool contains(const Vec3& point, double radius_mm = 0) const;
  /// Returns whether a line segment is proved to be in the material.
  [[nodiscard]] bool contains(const Vec3& from, const Vec3& to) const;
  /// Returns whether a prism is proved to be in the material.
  [[nodiscard]] bool contains(const Prism& prism) const;

  /// The signed distance of a point from the surface, negative inside, and the direction in which it grows.
  struct Distance {
    double mm = 0;
    Vec3 outward = Vec3::UnitZ();
  };
  /// Returns a distance that guides searches; nothing is proved with it. Outside a box it is the largest distance from one
  /// of its planes.
  [[nodiscard]] Distance signed_distance(const Vec3& point) const;
  /// Proves that no point within `slack_mm` >= 0 of a region is in the stock.
  [[nodiscard]] bool is_apart_from(const HullRegion& region, double slack_mm) const;
  /// Proves that all points within `slack_mm` >= 0 of a region are in the stock.
  [[nodiscard]] bool contains(const HullRegion& region, double slack_mm) const;

  /// Box about the stock.
  [[nodiscard]] const Vec3& low() const { return low_; }
  [[nodiscard]] const Vec3& high() const { return high_; }

 private:
  StockSolid() = default;
  [[nodiscard]] bool is_in_box(std::span<const Vec3> points) const;
  [[nodiscard]] bool is_clear_of_meshes(std::span<const Disc> discs, double apart_mm) const;

  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
  std::vector<Surface> surfaces_;  // none: the box itself
  double allowance_mm_ = 0;
};

}  // namespace gouge
