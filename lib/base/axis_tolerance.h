#pragma once

// Tolerances of controls that hold for each linear axis by itself.

namespace gouge {

/// Largest distance of a tool from its path, if each of three perpendicular axes is within 1 of its own place: the square
/// root of 3, rounded up.
inline constexpr double kThreeAxes = 1.7320508075688774;

/// Largest distance of a tool from its path under CYCLE832 with the contour tolerance 1. The tolerance is that of each axis,
/// and the cycle may switch on both smoothing and a compressor. Source: Siemens, NC programming, 12/2019, p. 1108.
inline constexpr double kSmoothingCycleShare = 2 * kThreeAxes;

}  // namespace gouge
