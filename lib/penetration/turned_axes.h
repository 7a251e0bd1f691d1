#pragma once

#include <cstddef>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/kdop/directions.h"

namespace gouge {

/// The directions of the standing body's volumes as the moving body sees them at one rotation.
///
/// Turning a volume means turning its corners and bounding them anew (thesis 6.1.4.2, figure 14). Turning the k / 2
/// axes the other way once, and taking the corners as they are, gives the same intervals. It costs 3 products an axis
/// and corner instead of 9 more a corner.
class TurnedAxes {
 public:
  explicit TurnedAxes(const DirectionSet& directions);

  void turn(const Eigen::Matrix3d& rotation);

  /// Intervals (intervals.h) of `count` blocks of four points: x x x x y y y y z z z z. Not widened.
  void bound(const float* blocks, std::size_t count, float* intervals) const;

 private:
  const DirectionSet& directions_;
  std::size_t stride_;
  std::vector<float> axes_;  ///< x of all, y of all, z of all
};

}  // namespace gouge
