#include "lib/check/tool_interval.h"

#include <cmath>

namespace gouge {

ToolFrame tool_frame(const Motion& motion, double t, std::uint32_t segment) {
  const Vec3& start_axis = motion.start().axis;
  const Vec3& turn_axis = motion.rotation_axis();
  ToolFrame frame;
  frame.tip = motion.tip_at(t, segment);
  const double turned = motion.angle_rad() * t;
  const Vec3 axis = std::cos(turned) * start_axis + std::sin(turned) * turn_axis.cross(start_axis);
  frame.rows.row(0) = turn_axis;
  frame.rows.row(1) = axis.cross(turn_axis);
  frame.rows.row(2) = axis;
  return frame;
}

ToolInterval::ToolInterval(const Motion& motion, const MotionInterval& interval)
    : MotionInterval(interval),
      f0(tool_frame(motion, t0, segment)),
      f1(tool_frame(motion, t1, segment)),
      tip_middle(0.5 * (f0.tip + f1.tip)),
      tip_path_mm(motion.path_length_mm(t0, t1, segment)),
      sag_mm(motion.sag_mm(t0, t1, segment)),
      turn_rad(motion.angle_rad() * (t1 - t0)) {}

}  // namespace gouge
