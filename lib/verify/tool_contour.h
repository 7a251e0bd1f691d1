#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// A tool's contour for the verifier: segments and arcs. Each arc is divided where its direction is along r or z, so
/// that both coordinates are monotone along a piece. The verifier uses no other part of a compiled tool.
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
    /// Returns the point of the piece that is nearest to q.
    [[nodiscard]] Vec2 foot(const Vec2& q) const;
  };

  struct Nearest {
    double signed_distance_mm = 0;  ///< to the contour; negative inside
    Vec2 foot = Vec2::Zero();
    Vec2 normal = Vec2::UnitX();  ///< unit, outward; approximate on the contour itself
    Body body = Body::cutter;
  };

  explicit ToolContour(const CompiledTool& tool);

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// Returns the maximum gap: between the end of a piece and the start of the next one, or between the axis and the
  /// first or last piece. With a gap the contour bounds nothing.
  [[nodiscard]] double largest_gap_mm() const;
  /// Returns whether the contour has no gap, up to rounding.
  [[nodiscard]] bool is_closed() const { return largest_gap_mm() <= kJoined_mm; }
  /// Finds the nearest point by examining every piece. The side is given by the number of times that a ray along r
  /// crosses the contour.
  [[nodiscard]] Nearest nearest(const Vec2& q) const;
  [[nodiscard]] bool has(const Vec2& q) const;
  /// Returns the distance to the pieces of one body.
  [[nodiscard]] double distance_to(Body body, const Vec2& q) const;
  /// Returns whether the contour has a concave corner or a hollow arc. Such a tool is not convex.
  [[nodiscard]] bool is_stepped() const { return is_stepped_; }
  /// Returns a bound of the distance of all points from the tip.
  [[nodiscard]] double size_mm() const { return size_mm_; }
  [[nodiscard]] double largest_radius_mm() const { return largest_radius_mm_; }
  /// Returns the heights of its lowest and highest point.
  [[nodiscard]] double low_mm() const { return low_mm_; }
  [[nodiscard]] double high_mm() const { return high_mm_; }

 private:
  static constexpr double kJoined_mm = 1e-9;

  void add_arc(const BoundaryElement& arc);

  std::vector<Piece> pieces_;
  double size_mm_ = 0, largest_radius_mm_ = 0, low_mm_ = 0, high_mm_ = 0;
  bool is_stepped_ = false;
};

}  // namespace gouge
