#pragma once

#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "lib/geom/vec.h"

namespace gouge {

/// Directions of tilt of a tool axis: any, forward and back in the feed direction, or to its sides alone.
enum class TiltFreedom : std::uint8_t { both, lead, side };

/// Tool axes no farther than `half_angle_rad` from `axis`, a unit vector.
struct AxisCone {
  Vec3 axis = Vec3::UnitZ();
  double half_angle_rad = 0;
};

/// Limits of a tilt, at every instant of the motions.
struct TiltOptions {
  double max_tilt_rad = std::numbers::pi / 6;  ///< from the programmed axis
  TiltFreedom freedom = TiltFreedom::both;
  std::optional<AxisCone> cone;  ///< none: any axis
  /// Returns how fast the axis may turn on a motion that the programmed axis does not turn faster on.
  double max_turn_rad_per_mm = std::numeric_limits<double>::infinity();
  double max_turn_step_rad = std::numeric_limits<double>::infinity();  ///< and on one motion
  double blend_mm = 10;  ///< way of the tip over which the tilt comes and goes, where the path has it
  /// Maximum rise of the tip off the part where the cutter would gouge when tilted. It leaves that stock uncut.
  double max_raise_mm = 1;
  /// Maximum beyond the tolerance that may be left of what the programmed path finished; infinite: it is not measured.
  double max_stock_mm = 0.01;

  [[nodiscard]] bool has_turn_limit() const {
    return max_turn_rad_per_mm < std::numeric_limits<double>::infinity() ||
           max_turn_step_rad < std::numeric_limits<double>::infinity();
  }
};

}  // namespace gouge
