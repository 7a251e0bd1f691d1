#pragma once

#include <vector>

#include "lib/tool/compiled_tool.h"
#include "lib/tool/foot_cells.h"

// Balls inside a tool that touch its boundary. Let a ball of radius R roll along the contour, and a surface come less
// than R deep into the tool. Then the tool's boundary reaches no farther below the surface than the surface is deep in
// the tool (docs/method/overcut.md).

namespace gouge {

using Box2 = Eigen::AlignedBox2d;

struct InscribedBall {
  Vec2 center = Vec2::Zero();  ///< (r, z), r >= 0
  double radius_mm = 0;        ///< of the tool no point nearer to the centre is missing; 0: none was found
};

/// Returns the largest ball found that touches the boundary at the foot of ray `s` of a cell, larger than `min_mm`.
/// Ensures  Its radius is the depth of its centre, and that is no more than `nearly_mm` less than the way to the foot.
/// Cost     Some evaluations.
[[nodiscard]] InscribedBall inscribed_ball(const CompiledTool& tool, const FootCell& cell, double s, double min_mm,
                                           double nearly_mm);

/// The balls inside a tool along the whole of its contour.
class InscribedBalls {
 public:
  /// `slack_mm`: how far a foot may lie out of its ball. Cost: some thousand evaluations.
  InscribedBalls(const CompiledTool& tool, double slack_mm);

  /// Returns boxes of the half plane, in the order of the contour. Take a point of the tool that is less than
  /// `depth_mm` deep and in none of them. It is at most slack_mm outside of a ball in the tool whose radius is at least
  /// `depth_mm`.
  /// Cost  Linear in the stretches of the contour, about a thousand.
  [[nodiscard]] std::vector<Box2> sharp_zones(double depth_mm) const;

  /// Returns whether the tool has one radius at each height.
  [[nodiscard]] bool is_single_valued() const { return is_single_valued_; }

 private:
  struct Stretch {
    Box2 feet;
    double radius_mm = 0;  // of a ball that reaches all of its feet but for the slack; 0: none
  };
  void cover(const CompiledTool& tool, const FootCell& cell);

  std::vector<Stretch> stretches_;
  double slack_mm_;
  bool is_single_valued_;
};

}  // namespace gouge
