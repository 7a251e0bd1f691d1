#include "lib/certify/motion_checker.h"

#include "lib/base/best_first_search.h"
#include "lib/check/check_move.h"
#include "lib/head/check_heads.h"

namespace gouge {
MotionChecker::MotionChecker(const CheckSetup& setup) : scene_(setup.scene), options_(setup.options) {
  if (!setup.heads.empty() && scene_.is_within_reach) heads_ = std::make_unique<HeadChecker>(setup.heads, scene_);
}

MotionChecker::~MotionChecker() = default;

MoveVerdict MotionChecker::check(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                 const CheckOptions& options, bool is_start_outside) const {
  MoveVerdict verdict = check_move(motion, kind, tool, scene_, options);
  if (verdict.state == MoveState::not_checked) return verdict;
  if (heads_) heads_->check(motion, options, verdict);
  if (verdict.state != MoveState::clean && verdict.state != MoveState::near_miss) return verdict;
  if (verdict.depth_upper_mm >= tool.bare.core_depth_mm) {
    verdict.state = MoveState::not_certified;
    verdict.reason = {Reason::Kind::body_too_thin, Body::cutter};
  } else if (!is_start_outside && side_of(motion.start(), tool) == Side::inside) {
    verdict.state = MoveState::buried;
    verdict.reason = {Reason::Kind::buried, Body::cutter};
  }
  return verdict;
}

bool MotionChecker::is_clean(const Motion& motion, MoveKind kind, const ToolVariants& tool, const CheckOptions& options,
                             bool is_start_outside) const {
  if (!motion.is_defined()) return false;
  CheckOptions quick = options;
  quick.gouge_gap_mm = kAnyGap_mm;
  return check(motion, kind, tool, quick, is_start_outside).state == MoveState::clean;
}

MoveVerdict MotionChecker::measure(const Pose& pose, MoveKind kind, const ToolVariants& tool) const {
  CheckOptions exact = options_;
  exact.tolerance_mm = 0;
  exact.near_miss_mm = 0;
  exact.is_depth_alone = true;
  return check(Motion(pose), kind, tool, exact, true);
}

double MotionChecker::head_excess(const Pose& pose, double allowed_mm, double accuracy_mm) const {
  return heads_ ? heads_->excess_at(pose, allowed_mm, accuracy_mm) : 0;
}

Side MotionChecker::side_of(const Pose& pose, const ToolVariants& tool) const {
  const Vec3 core = pose.tip + tool.bare.core.y() * pose.axis;
  return scene_.sides().side_of({{core}, {pose.axis}}).side;
}

}  // namespace gouge
