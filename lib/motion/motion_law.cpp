#include "lib/motion/motion_law.h"

namespace gouge {

Motion MotionLaw::of(const Toolpath& toolpath, std::size_t index) const {
  const Move& move = toolpath.moves[index];
  if (!move.has_start) return at(move.end);
  const Pose& start = toolpath.start_of(index);
  if (move.curve_kind == CurveKind::arc) return along(start, move.end, toolpath.arcs[move.curve]);
  if (move.curve_kind == CurveKind::spline) return along(start, move.end, toolpath.splines[move.curve]);
  return between(start, move.end, move.kind);
}

std::optional<Motion> MotionLaw::link_of(const Toolpath& toolpath, std::size_t index) const {
  const Move& move = toolpath.moves[index];
  if (move.has_start || !move.is_linked || index == 0) return std::nullopt;
  return straight(toolpath.moves[index - 1].end, move.end);
}

Motion MotionLaw::at(const Pose& pose) const {
  Motion motion = straight(pose, pose);
  motion.is_alone_ = true;
  return motion;
}

Motion MotionLaw::between(const Pose& from, const Pose& to, MoveKind kind) const {
  Motion motion = straight(from, to);
  if (kind == MoveKind::rapid && rapid_ == RapidMode::dogleg) motion.run_dogleg();
  return motion;
}

Motion MotionLaw::along(const Pose& from, const Pose& to, const PathArc& arc) const {
  Motion motion = straight(from, to);
  motion.run_along(arc);
  return motion;
}

Motion MotionLaw::along(const Pose& from, const Pose& to, const PathSpline& spline) const {
  Motion motion = straight(from, to);
  motion.run_along(spline);
  return motion;
}

}  // namespace gouge
