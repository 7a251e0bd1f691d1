#pragma once

#include "lib/geom/vec.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_interval.h"

// Time intervals of a move, and the tool frames at their ends.

namespace gouge {

/// Tool coordinates at one instant: z along the tool axis, x and y as Motion::axes_at gives them.
struct ToolFrame {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Identity();
  Vec3 tip = Vec3::Zero();
  [[nodiscard]] Vec3 to_tool(const Vec3& p_part) const { return rows * (p_part - tip); }
};

/// Returns the frame at t within the segment. Requires motion.is_defined().
[[nodiscard]] ToolFrame tool_frame(const Motion& motion, double t, std::uint32_t segment);

/// A time interval of a tool's motion.
struct ToolInterval : MotionInterval {
  ToolInterval(const Motion& motion, const MotionInterval& interval);

  ToolFrame f0, f1;
  Vec3 tip_middle;  ///< of the tip's chord
  MotionRates rates;
};

using ToolIntervals = IntervalTree<ToolInterval, Motion>;

}  // namespace gouge
