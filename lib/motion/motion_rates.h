#pragma once

#include <cmath>

namespace gouge {

/// Bounds of a rigid body's motion over a time interval, lengths in mm, angles in radians. The body turns about its
/// tip; w is its angular velocity, h the length of the interval. Proofs: docs/method/certified_sweep.md, section 3.
struct MotionRates {
  double tip_path_mm = 0;     ///< the tip's path is no longer (a straight one is just as long)
  double tip_sag_mm = 0;      ///< how far the tip may be from the straight chord at constant speed
  double turn_rad = 0;        ///< |w| h is no more
  double turn_sag_rad = 0;    ///< |w'| h^2 is no more; 0 at a constant rate about a fixed direction
  double off_circle_rad = 0;  ///< how far the axis may be from the great circle between its ends at constant rate

  /// Bounds |axis''| h^2.
  [[nodiscard]] double axis_acceleration_rad() const { return turn_rad * turn_rad + turn_sag_rad; }

  /// Bounds the distance, in the body's frame, of the path of a point of the part from its chord. The straight chord
  /// joins its positions at both ends.
  /// Requires: the point is no farther from the middle of the tip's chord than `distance_mm`.
  [[nodiscard]] double bulge_mm(double distance_mm) const {
    return (2 * turn_rad * tip_path_mm + axis_acceleration_rad() * (distance_mm + 0.5 * tip_path_mm)) / 8 + tip_sag_mm;
  }
};

}  // namespace gouge
