#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"
#include "lib/tool/foot_cells.h"

// Balls inside a tool that touch its boundary. Let a ball of radius R roll along the contour, and let a surface be less
// than R deep in the tool. Then the depth of the surface in the tool bounds how far the tool's boundary reaches below
// the surface (docs/method/overcut.md).

namespace gouge {

using Box2 = Eigen::AlignedBox2d;

struct InscribedBall {
  Vec2 center = Vec2::Zero();  ///< (r, z), r >= 0
  double radius_mm = 0;        ///< the ball contains only points of the tool; 0: no ball was found
};

/// Returns the largest found ball that touches the boundary at the foot of ray `s` of a cell. The ball is larger than
/// `min_mm`.
/// Ensures  Its radius is the depth of its centre. The radius is at most `nearly_mm` less than the distance to the
///          foot.
/// Cost     A few evaluations.
[[nodiscard]] InscribedBall inscribed_ball(const CompiledTool& tool, const FootCell& cell, double s, double min_mm,
                                           double nearly_mm);

/// The balls inside a tool along its whole contour.
class InscribedBalls {
 public:
  /// `slack_mm` is the maximum distance of a foot outside of its ball. Cost: a few thousand evaluations.
  InscribedBalls(const CompiledTool& tool, double slack_mm);

  /// Returns boxes of the half plane, in the order of the contour. Consider a point of the tool that is less than
  /// `depth_mm` deep and in none of the boxes. It is at most slack_mm outside of a ball in the tool whose radius is at
  /// least `depth_mm`.
  /// Cost  Linear in the number of stretches of the contour, about a thousand.
  [[nodiscard]] std::vector<Box2> sharp_zones(double depth_mm) const;

  /// Returns whether the tool has exactly one radius at each height.
  [[nodiscard]] bool is_single_valued() const { return is_single_valued_; }

 private:
  struct Stretch {
    FootCell cell;
    double radius_mm = 0;  // of a ball that contains all feet of the cell, up to the slack; 0: none
  };
  void cover(const CompiledTool& tool, const FootCell& cell);

  std::vector<Stretch> stretches_;
  double slack_mm_;
  bool is_single_valued_;
};

}  // namespace gouge
