#pragma once

#include <vector>

#include "lib/stock/disc.h"
#include "lib/tool/compiled_tool.h"

// The material that a cutter surely removes at one instant: convex solids of revolution inside the cutter.

namespace gouge {

/// A convex solid of revolution about the tool axis, in the tool's half plane: the intersection of its faces.
struct ConvexPiece {
  /// A line or an arc of the contour that bounds the solid.
  struct Face {
    Vec2 normal = Vec2::Zero();  ///< line: {q : normal . q <= offset}; unit, outward
    double offset_mm = 0;
    bool is_arc = false;  ///< arc: its disc between the tangents at its two ends
    Vec2 center = Vec2::Zero();
    double radius_mm = 0;
    Vec2 normal_a = Vec2::Zero(), normal_b = Vec2::Zero();  ///< unit, outward, at the start and the end of the arc
  };
  double z_lo_mm = 0, z_hi_mm = 0;
  double r_max_mm = 0;
  std::vector<Face> faces;  ///< besides both ends
  /// Points whose value is at most growth * d are within d of the solid, for d >= 0. It is the least sine of half the
  /// interior angle at a corner.
  double growth = 1;

  /// Returns a convex function of (r, z). Where it is -d < 0, the point is inside the solid and at least d from its
  /// boundary. Requires r >= 0.
  [[nodiscard]] double value(double r_mm, double z_mm) const;
  /// Returns an upper bound of the largest value on a disc, for a tool whose tip is at the origin and whose axis is
  /// `axis`. It is exact for points and for discs across the axis.
  [[nodiscard]] double value(const Disc& disc, const Vec3& tip, const Vec3& axis) const;
};

/// Returns convex pieces of the part of the solid that belongs to the cutter, from the tip up. They lie inside the
/// cutter; a convex cutter is one piece. Hollow undersides and undercuts that turn back in height are left out.
///
/// Cost   Linear in the number of elements. A reflex arc gives kReflexParts pieces.
/// Source The split at reflex corners is that of lib/tool/convex_cover, from inside.
[[nodiscard]] std::vector<ConvexPiece> convex_pieces(const CompiledTool& tool);

/// Number of pieces into which an arc with the solid outside its circle is divided.
inline constexpr int kReflexParts = 12;

}  // namespace gouge
