#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "lib/geom/vec.h"
#include "lib/motion/pose_reach.h"

namespace gouge {

/// Allowed directions of tilt of a tool axis: any; only forward and back in the feed direction; only to the sides.
enum class TiltFreedom : std::uint8_t { both, lead, side };

/// The tool axes within `half_angle_rad` of `axis`, a unit vector.
struct AxisCone {
  Vec3 axis = Vec3::UnitZ();
  double half_angle_rad = 0;
};

/// Limits of a tilt. They hold at every instant of the motions.
struct TiltOptions {
  double max_tilt_rad = std::numbers::pi / 6;  ///< from the programmed axis
  TiltFreedom freedom = TiltFreedom::both;
  std::optional<AxisCone> cone;  ///< none: any axis
  /// The machine that must reach the tilted positions; null: any machine.
  std::shared_ptr<const PoseReach> reach;
  /// Maximum turn of the axis on a motion. It does not apply where the programmed axis turns more.
  double max_turn_rad_per_mm = std::numeric_limits<double>::infinity();
  double max_turn_step_rad = std::numeric_limits<double>::infinity();  ///< maximum turn on one motion
  double blend_mm = 10;  ///< length of the tip's path over which the tilt increases and decreases, where the path is
                         ///< long enough
  /// Maximum rise of the tip off the part where the tilted cutter would gouge. The rise leaves stock uncut.
  double max_raise_mm = 1;
  /// Maximum stock, beyond the tolerance, that may be left on surfaces that the programmed path finished; infinite: it
  /// is not measured.
  double max_stock_mm = 0.01;

  [[nodiscard]] bool has_turn_limit() const {
    return max_turn_rad_per_mm < std::numeric_limits<double>::infinity() ||
           max_turn_step_rad < std::numeric_limits<double>::infinity();
  }
};

}  // namespace gouge
