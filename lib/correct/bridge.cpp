#include "lib/correct/bridge.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr int kLevels = 7;            // halvings of a motion before another way is tried
constexpr std::size_t kLargest = 24;  // positions put into one motion
constexpr double kFirstLift_mm = 0.25;
constexpr double kLiftGrowth = 1.4;
constexpr double kGap_mm = 0.02;      // how well the worst instant of a gouging motion is found
constexpr double kNoMatter_mm = 1e6;  // the gap when only the verdict counts

class Bridger {
 public:
  explicit Bridger(const BridgeTask& task) : task_(task) {}

  bool halve(const Pose& from, const Pose& to, int level, std::vector<BridgePose>& way) {
    const Motion motion = motion_between(from, to);
    if (!motion.is_defined()) return false;
    const MoveVerdict verdict = check(motion);
    if (verdict.state == MoveState::not_certified || verdict.state == MoveState::buried) return false;
    if (verdict.state != MoveState::gouge) return true;
    const double t = verdict.witness ? verdict.witness->t : 0;
    if (level == 0 || way.size() >= kLargest || t <= 0 || t >= 1) return false;
    BridgePose stop;
    stop.before = motion.at(t);
    stop.depth_before_mm = verdict.depth_mm;
    const auto corrected = correct_pose(task_.strategy, stop.before, *task_.tool, *task_.scene, task_.limits);
    if (!corrected) return false;
    stop.corrected = *corrected;
    if (!halve(from, corrected->pose, level - 1, way)) return false;
    way.push_back(stop);
    return halve(corrected->pose, to, level - 1, way);
  }

  std::optional<std::vector<BridgePose>> over(const Pose& from, const Pose& to) {
    const MoveVerdict direct = check(motion_between(from, to));
    for (double lift = kFirstLift_mm; lift <= task_.limits.largest_shift_mm; lift *= kLiftGrowth) {
      const Pose up = lifted(from, lift);
      const Pose down = lifted(to, lift);
      if (is_clean(from, up) && is_clean(up, down) && is_clean(down, to)) {
        return std::vector<BridgePose>{stop(from, up, lift, direct.depth_mm),
                                       stop(to, down, lift, direct.depth_mm)};
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Motion motion_between(const Pose& from, const Pose& to) const {
    return Motion(from, to, task_.kind == MoveKind::rapid && task_.options.rapid == RapidMode::dogleg);
  }

  [[nodiscard]] MoveVerdict check(const Motion& motion) const {
    CheckOptions options = task_.options;
    options.gouge_gap_mm = kGap_mm;
    return check(motion, options);
  }

  [[nodiscard]] MoveVerdict check(const Motion& motion, const CheckOptions& options) const {
    MoveVerdict verdict = check_move(motion, task_.kind, *task_.tool, *task_.scene, options);
    if (task_.limits.heads != nullptr) task_.limits.heads->check(motion, options, verdict);
    return verdict;
  }

  [[nodiscard]] bool is_clean(const Pose& from, const Pose& to) const {
    const Motion motion = motion_between(from, to);
    if (!motion.is_defined()) return false;
    CheckOptions options = task_.options;
    options.gouge_gap_mm = kNoMatter_mm;
    const MoveState state = check(motion, options).state;
    return state == MoveState::clean || state == MoveState::near_miss;
  }

  static Pose lifted(const Pose& pose, double lift) { return {pose.tip + lift * pose.axis, pose.axis}; }

  static BridgePose stop(const Pose& before, const Pose& after, double lift, double depth) {
    return {{after, Strategy::axis, lift, 1}, before, depth};
  }

  const BridgeTask& task_;
};

}  // namespace

std::optional<std::vector<BridgePose>> bridge(const Pose& from, const Pose& to, const BridgeTask& task) {
  Bridger bridger(task);
  std::vector<BridgePose> way;
  if (bridger.halve(from, to, kLevels, way)) return way;
  return bridger.over(from, to);
}

}  // namespace gouge
