#pragma once

#include "lib/check/motion.h"
#include "lib/check/motion_interval.h"
#include "lib/geom/vec.h"

// Time intervals of a move, and the tool frames at their ends.

namespace gouge {

/// Tool coordinates at one instant: x along the rotation axis of the move, z along the tool axis.
struct ToolFrame {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Identity();
  Vec3 tip = Vec3::Zero();
  [[nodiscard]] Vec3 to_tool(const Vec3& p_part) const { return rows * (p_part - tip); }
};

/// At t within the segment. Requires motion.is_defined().
[[nodiscard]] ToolFrame tool_frame(const Motion& motion, double t, std::uint32_t segment);

/// A time interval of a tool's motion.
struct ToolInterval : MotionInterval {
  ToolInterval(const Motion& motion, const MotionInterval& interval);

  ToolFrame f0, f1;
  Vec3 tip_middle;
  double tip_path_mm;  ///< the tip's path over the interval is no longer (a straight one is just as long)
  double sag_mm;       ///< how far the tip may be from where it would be on the straight chord
  double turn_rad;     ///< rotation over the interval

  /// How far the path of a point, `distance_mm` or less from the tip at mid interval, may bulge from the straight
  /// chord between its positions at the two ends, in tool coordinates. Proof:
  /// docs/algorithms/certified_sweep.md.
  [[nodiscard]] double bulge_mm(double distance_mm) const {
    return (2 * turn_rad * tip_path_mm + turn_rad * turn_rad * (distance_mm + 0.5 * tip_path_mm)) / 8 + sag_mm;
  }
};

using ToolIntervals = IntervalTree<ToolInterval, Motion>;

}  // namespace gouge
