#include "lib/motion/motion_law.h"

#include "lib/path/run_kind.h"

namespace gouge {

std::string MotionLaw::name() const {
  const std::string feed = feed_axes_ ? feed_axes_->name() : "great-circle";
  const std::string rapid = rapid_axes_ ? rapid_axes_->name() : "great-circle";
  std::string text = feed == rapid ? feed : feed + ", rapids " + rapid;
  if (joint_feed_axes_ == nullptr) return text;
  text += ", without tool centre point control " + joint_feed_axes_->name();
  return joint_rapid_axes_->name() == joint_feed_axes_->name() ? text : text + ", rapids " + joint_rapid_axes_->name();
}

std::optional<MotionLaw> MotionLaw::widest() const {
  if (!widest_feed_axes_ && !widest_rapid_axes_) return std::nullopt;
  MotionLaw law(rapid_, widest_feed_axes_ ? widest_feed_axes_ : feed_axes_,
                widest_rapid_axes_ ? widest_rapid_axes_ : rapid_axes_);
  law.set_joint_axes(joint_feed_axes_, joint_rapid_axes_);
  return law;
}

std::string MotionLaw::why_open(const Toolpath& toolpath, std::size_t move) const {
  const AxisLaw* const axes = axes_of(toolpath.moves[move]);
  return axes == nullptr ? std::string() : axes->why_open(toolpath, move);
}

bool MotionLaw::bends_without_turning() const {
  const auto bends = [](const std::shared_ptr<const AxisLaw>& axes) { return axes && axes->bends_without_turning(); };
  return bends(feed_axes_) || bends(rapid_axes_) || bends(joint_feed_axes_) || bends(joint_rapid_axes_);
}

Motion MotionLaw::of(const Toolpath& toolpath, std::size_t index) const {
  const Move& move = toolpath.moves[index];
  if (!move.has_start) {
    Motion alone(move.end, move.end, feed_axes_.get(), &toolpath, index);
    alone.is_alone_ = true;
    return alone;
  }
  Motion motion(toolpath.start_of(index), move.end, axes_of(move), &toolpath, index);
  // No law of the tip covers the joints of a move without tool centre point control.
  const bool is_open =
      move.runs_joints && joint_feed_axes_ == nullptr && toolpath.start_of(index).axis != move.end.axis;
  motion.is_defined_ = motion.is_defined_ && !is_open;
  if (move.curve_kind == CurveKind::arc) {
    motion.run_along(toolpath.arcs[move.curve]);
  } else if (move.curve_kind == CurveKind::spline) {
    motion.run_along(toolpath.splines[move.curve]);
  } else if (runs_rapid(move) && rapid_ == RapidMode::dogleg) {
    motion.run_dogleg();
  }
  return motion;
}

bool MotionLaw::has_other_rapid(const Toolpath& toolpath, std::size_t index) const {
  const Move& move = toolpath.moves[index];
  if (!move.has_start) return false;
  const Pose& start = toolpath.start_of(index);
  const auto named = [](const AxisLaw* axes) { return axes == nullptr ? std::string() : axes->name(); };
  const AxisLaw *feed = axes_of(move, MoveKind::feed), *rapid = axes_of(move, MoveKind::rapid);
  const bool is_turning = start.axis != move.end.axis || bends_without_turning();
  if (is_turning && named(feed) != named(rapid)) return true;
  const Vec3 step = move.end.tip - start.tip;
  return rapid_ == RapidMode::dogleg && (step.array() != 0).count() > 1;
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
  Motion motion(from, to, axes_of(kind));
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
