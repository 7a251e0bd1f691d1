#pragma once

#include <vector>

#include "lib/tilt/tilt_lattice.h"

namespace gouge {

/// A position with a prescribed tilt of the curve.
struct TiltAnchor {
  std::size_t position = 0;
  Tilt tilt = Tilt::Zero();
};

/// Finds the curve through anchors with the minimum integral of |second derivative by the arc length|^2. It is a cubic
/// spline. The result has one value for each of `arc_lengths_mm`, which do not decrease.
///
/// Requires at least one anchor, in the order of their positions, and no two anchors at the same arc length.
/// Ensures  An end whose `is_level` is true has slope zero, because the path continues without tilt there. Any other
///          end has no curvature. Beyond the first and the last anchor the curve is straight.
/// Cost     Linear.
/// Source   C. de Boor, A Practical Guide to Splines (1978), IV.
[[nodiscard]] TiltSequence curve_through(const std::vector<TiltAnchor>& anchors,
                                         const std::vector<double>& arc_lengths_mm, bool is_first_level,
                                         bool is_last_level);

/// Returns the BendingSum of a sequence, rad^2/mm^3. Of positions with equal arc lengths only the first counts.
[[nodiscard]] double roughness(const TiltSequence& tilts, const std::vector<double>& arc_lengths_mm);

}  // namespace gouge
