#pragma once

#include <vector>

#include "lib/tilt/tilt_lattice.h"

namespace gouge {

/// A position whose tilt a curve must have.
struct TiltAnchor {
  std::size_t position = 0;
  Tilt tilt = Tilt::Zero();
};

/// Finds the curve of least integral of |second derivative by the way|^2 through anchors. It is a cubic spline, with
/// one value for each of `arc_lengths_mm`, which do not fall.
///
/// Requires at least one anchor, in the order of their positions, no two at one way.
/// Ensures  An end of which `is_level` is true has no slope, as the path goes on untilted there. Any other end has no
///          curvature. Beyond the first and last anchor the curve goes on straight.
/// Cost     Linear.
/// Source   C. de Boor, A Practical Guide to Splines (1978), IV.
[[nodiscard]] TiltSequence curve_through(const std::vector<TiltAnchor>& anchors,
                                         const std::vector<double>& arc_lengths_mm, bool is_first_level,
                                         bool is_last_level);

/// Returns the BendingSum of a sequence, rad^2/mm^3. Where two ways are the same the later is left out.
[[nodiscard]] double roughness(const TiltSequence& tilts, const std::vector<double>& arc_lengths_mm);

}  // namespace gouge
