#pragma once

#include <span>
#include <vector>

#include "lib/mesh/indexed_mesh.h"
#include "lib/motion/body_motion.h"
#include "lib/stock/contour_hulls.h"
#include "lib/stock/disc.h"
#include "lib/stock/motion_tree.h"
#include "lib/stock/stock_solid.h"
#include "lib/surface/surface.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// A body that moves with the tool and is no part of its profile, for the questions about stock. Frame of the tool, mm.
class StockHead {
 public:
  /// Takes the boundary of a closed solid, moved out by `grow_mm` >= 0 in all directions. Its mesh must outlive the head.
  explicit StockHead(const Surface& boundary, double grow_mm = 0);
  /// Returns the same body, moved out further.
  [[nodiscard]] StockHead grown(double by_mm) const { return StockHead(surface_, grow_mm_ + by_mm); }

  /// Returns a solid of revolution about the tool axis that contains the body, for `deep_pieces` and the like.
  [[nodiscard]] const CompiledTool& around() const { return around_; }
  /// Returns hulls that contain it together, and a cylinder about them.
  [[nodiscard]] const std::vector<ContourHull>& hulls() const { return hulls_; }
  [[nodiscard]] const ToolCylinder& cylinder() const { return cylinder_; }
  /// Bounds the distance of its points from the tip.
  [[nodiscard]] double reach_mm() const { return reach_mm_; }

  /// Proves that no point of the hull of the discs is deeper than `depth_mm` >= 0.
  [[nodiscard]] bool is_no_deeper(std::span<const Disc> discs, double depth_mm) const {
    return solid_.is_clear_of(discs, grow_mm_ - depth_mm);
  }
  /// Returns the signed distance of a point, negative inside.
  [[nodiscard]] double signed_distance_mm(const Vec3& point) const {
    return surface_.closest_point(point)->signed_mm() - grow_mm_;
  }
  /// Returns the unit direction in which that distance grows.
  [[nodiscard]] Vec3 outward(const Vec3& point) const { return surface_.closest_point(point)->normal; }

 private:
  Surface surface_;
  double grow_mm_;
  StockSolid solid_;
  CompiledTool around_;
  std::vector<ContourHull> hulls_;
  ToolCylinder cylinder_;
  double reach_mm_ = 0;
};

/// Returns whether the turn of a body about the tool axis is known at every instant of a motion.
[[nodiscard]] inline bool has_known_turn(const Motion& motion) { return !motion.is_any() && !motion.has_other(); }

/// Returns the contour of cylinders, one above the other, that contain a mesh, moved out by `grow_mm`. It has no elements if
/// the mesh has no height.
/// Cost  O(triangles x heights at which it is cut).
[[nodiscard]] CompiledTool cylinders_around(const IndexedMesh& mesh, double grow_mm = 0);

}  // namespace gouge
