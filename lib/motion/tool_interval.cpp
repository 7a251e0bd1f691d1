#include "lib/motion/tool_interval.h"

namespace gouge {

ToolFrame tool_frame(const Motion& motion, double t, std::uint32_t segment) {
  return {motion.axes_at(t).transpose(), motion.tip_at(t, segment)};
}

ToolInterval::ToolInterval(const Motion& motion, const MotionInterval& interval)
    : MotionInterval(interval),
      f0(tool_frame(motion, t0, segment)),
      f1(tool_frame(motion, t1, segment)),
      tip_middle(0.5 * (f0.tip + f1.tip)),
      rates(motion.rates(t0, t1, segment)) {}

}  // namespace gouge
