#include "lib/check/path_motion.h"

namespace gouge {

Motion motion_of(const Toolpath& toolpath, std::size_t index, RapidMode rapid) {
  const Move& move = toolpath.moves[index];
  if (!move.has_start) return Motion(move.end);
  const Pose& start = toolpath.start_of(index);
  if (move.curve_kind == CurveKind::arc) return Motion(start, move.end, toolpath.arcs[move.curve]);
  if (move.curve_kind == CurveKind::spline) return Motion(start, move.end, toolpath.splines[move.curve]);
  return Motion(start, move.end, move.kind == MoveKind::rapid && rapid == RapidMode::dogleg);
}

std::optional<Motion> link_of(const Toolpath& toolpath, std::size_t index) {
  const Move& move = toolpath.moves[index];
  if (move.has_start || !move.is_linked || index == 0) return std::nullopt;
  return Motion(toolpath.moves[index - 1].end, move.end);
}

}  // namespace gouge
