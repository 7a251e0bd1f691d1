#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// A tool's contour as the verifier sees it: segments and arcs. Each arc is cut where it points along r or z, so that
/// both coordinates only grow or only fall along a piece. Nothing else of a compiled tool is used.
class ToolContour {
 public:
  struct Piece {
    Body body = Body::cutter;
    bool is_arc = false;
    bool is_hollow = false;  ///< arc: the tool is outside of its circle
    Vec2 a = Vec2::Zero(), b = Vec2::Zero();
    Vec2 center = Vec2::Zero();
    double radius_mm = 0;
    [[nodiscard]] double z_lo() const { return std::min(a.y(), b.y()); }
    [[nodiscard]] double z_hi() const { return std::max(a.y(), b.y()); }
    [[nodiscard]] double r_hi() const { return std::max(a.x(), b.x()); }
    /// Returns the normal of the piece nearest to q.
    [[nodiscard]] Vec2 foot(const Vec2& q) const;
  };

  struct Nearest {
    double signed_distance_mm = 0;  ///< to the contour; negative inside
    Vec2 foot = Vec2::Zero();
    Vec2 normal = Vec2::UnitX();  ///< unit, outward; about so on the contour itself
    Body body = Body::cutter;
  };

  explicit ToolContour(const CompiledTool& tool);

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// No piece ends farther than this from where the next begins, nor the first and last from the axis: else
  /// it bounds nothing.
  [[nodiscard]] double largest_gap_mm() const;
  /// Finds the nearest point by examining every piece. The side follows from how often a ray along r crosses the
  /// contour.
  [[nodiscard]] Nearest nearest(const Vec2& q) const;
  [[nodiscard]] bool has(const Vec2& q) const;
  /// Returns the distance to the pieces of one body.
  [[nodiscard]] double distance_to(Body body, const Vec2& q) const;
  /// Returns whether it has a corner that goes in, or a hollow arc: such a tool is not a convex body.
  [[nodiscard]] bool is_stepped() const { return is_stepped_; }
  /// Bounds the distance of all points from the tip.
  [[nodiscard]] double size_mm() const { return size_mm_; }

 private:
  void add_arc(const BoundaryElement& arc);

  std::vector<Piece> pieces_;
  double size_mm_ = 0;
  bool is_stepped_ = false;
};

}  // namespace gouge
