#pragma once

namespace gouge {

/// Largest departure of the tool from its law of motion, as a control that smooths the path allows it. At every instant
/// the tip may be `tip_mm` from its place and the tool axis `axis_rad` from its direction, in any direction.
///
/// The check covers it by the tool: every body is swept over all tilts about the tip (toolmodels/tilt_sweep.h) and then
/// grows by `tip_mm`. Proof: docs/method/machine.md, section "Tolerance tube".
struct MotionTube {
  double tip_mm = 0;    ///< >= 0
  double axis_rad = 0;  ///< in [0, pi / 4)

  [[nodiscard]] bool is_empty() const { return !(tip_mm > 0) && !(axis_rad > 0); }
};

/// A control that departs farther follows another path.
inline constexpr double kMaxAxisTolerance_deg = 10;

}  // namespace gouge
