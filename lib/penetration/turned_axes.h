#pragma once

#include <cstddef>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/kdop/directions.h"

namespace gouge {

/// The directions of the stationary body's volumes in the frame of the moving body at one rotation.
///
/// To turn a volume means to turn its corners and to bound them anew (thesis 6.1.4.2, figure 14). The same intervals
/// result if the k / 2 axes are turned once in the opposite direction and the corners stay. That costs 3 products for
/// each axis and corner, and saves 9 products for each corner.
class TurnedAxes {
 public:
  explicit TurnedAxes(const DirectionSet& directions);

  void turn(const Eigen::Matrix3d& rotation);

  /// Computes the intervals (intervals.h) of `count` blocks of four points: x x x x y y y y z z z z. They are not
  /// widened.
  void bound(const float* blocks, std::size_t count, float* intervals) const;

 private:
  const DirectionSet& directions_;
  std::size_t stride_;
  std::vector<float> axes_;  ///< first the x of all axes, then all y, then all z
};

}  // namespace gouge
