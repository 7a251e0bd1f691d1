#pragma once

#include <vector>

#include "lib/geom/vec.h"

// A convex, possibly unbounded cell of the half plane. Corners are homogeneous: (x, y, 1) is a point, and (x, y, 0) of
// unit length is a direction in which the cell is unbounded.

namespace gouge::detail {

/// A line with a direction of unit length; value(q) = direction . (q - through).
struct DirectedLine {
  Vec2 through = Vec2::Zero();
  Vec2 direction = Vec2::Zero();

  [[nodiscard]] double at(const Vec2& q) const { return direction.dot(q - through); }
};

struct CellSides {
  bool has_negative = false, has_positive = false;  ///< a corner lies on this side by more than the slack
};

class ConvexCell {
 public:
  /// Makes the cell of the half plane r >= 0. Slacks and samples are relative to the length `size_mm`.
  explicit ConvexCell(double size_mm);

  [[nodiscard]] const std::vector<Vec3>& corners() const { return corners_; }
  [[nodiscard]] CellSides sides(const DirectedLine& line) const;
  /// Returns the part on the negative (sign < 0) or positive side.
  [[nodiscard]] ConvexCell clipped(const DirectedLine& line, int sign) const;
  /// Returns points of the cell: finite corners, and their mean moved along the directions.
  [[nodiscard]] std::vector<Vec2> samples() const;
  [[nodiscard]] double area_within(const Vec2& low, const Vec2& high) const;
  /// Returns the rounding allowed at a corner; it grows with the distance of the corner from the tool.
  [[nodiscard]] double slack_at(const Vec3& corner) const;

 private:
  void add_corner_amid(const DirectedLine& line);

  std::vector<Vec3> corners_;
  double size_mm_ = 1;
};

}  // namespace gouge::detail
