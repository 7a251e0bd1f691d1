#pragma once

namespace gouge {

/// A corrected position is as deep as half of the tolerance at the most: the other half is for the rounding of the
/// written numbers and for the motion between corrected positions.
inline constexpr double kPositionAimShare = 0.5;

/// Motions between corrected positions are held to this share of the tolerance: the rest is for the file's digits.
inline constexpr double kMotionAimShare = 0.8;

/// What has no business at a surface, fixtures and bodies that must keep a clearance, gets this much air.
inline constexpr double kAir_mm = 2e-3;

}  // namespace gouge
