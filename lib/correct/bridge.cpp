#include "lib/correct/bridge.h"

#include <algorithm>
#include <utility>

namespace gouge {
namespace {

constexpr int kLevels = 7;            // halvings of a motion before another way is tried
constexpr std::size_t kLargest = 24;  // positions put into one motion
constexpr double kFirstLift_mm = 0.25;
constexpr double kLiftGrowth = 1.4;
constexpr double kGap_mm = 0.02;      // how well the worst instant of a gouging motion is found
constexpr double kNoMatter_mm = 1e6;  // the gap when only the verdict counts
constexpr double kStraight_mm = 1e-3;  // how far off its neighbours' straight way a position may be left out
constexpr double kStraightAxis = 1e-5;

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

  /// The crossing keeps `clearance_mm`; what leads up to it and down again does not.
  std::optional<std::vector<BridgePose>> over(const Pose& from, const Pose& to, double clearance_mm) {
    const MoveVerdict direct = check(motion_between(from, to));
    for (double lift = kFirstLift_mm; lift <= task_.limits.largest_shift_mm; lift *= kLiftGrowth) {
      const Pose up = lifted(from, lift);
      const Pose down = lifted(to, lift);
      if (is_clean(from, up) && is_clean(up, down, clearance_mm) && is_clean(down, to)) {
        return std::vector<BridgePose>{stop(from, up, lift, direct.depth_mm),
                                       stop(to, down, lift, direct.depth_mm)};
      }
    }
    return std::nullopt;
  }

  void leave_out_needless(const Pose& from, const Pose& to, std::vector<BridgePose>& way) {
    std::vector<BridgePose> kept;
    std::vector<Pose> left_out;  // since the last one kept
    for (std::size_t k = 0; k < way.size(); ++k) {
      const Pose& last = kept.empty() ? from : kept.back().corrected.pose;
      const Pose& next = k + 1 < way.size() ? way[k + 1].corrected.pose : to;
      left_out.push_back(way[k].corrected.pose);
      const bool is_straight = std::all_of(left_out.begin(), left_out.end(),
                                           [&](const Pose& pose) { return is_on_the_way(last, next, pose); });
      if (is_straight && is_clean(last, next)) continue;
      kept.push_back(way[k]);
      left_out.clear();
    }
    way = std::move(kept);
  }

  [[nodiscard]] bool is_clean(const Pose& from, const Pose& to, double clearance_mm = 0) const {
    const Motion motion = motion_between(from, to);
    if (!motion.is_defined()) return false;
    CheckOptions options = task_.options;
    options.gouge_gap_mm = kNoMatter_mm;
    options.near_miss_mm = clearance_mm;
    return check(motion, options).state == MoveState::clean;
  }

 private:
  // Where a dogleg runs straight is not asked: all its positions stay.
  [[nodiscard]] bool is_on_the_way(const Pose& from, const Pose& to, const Pose& pose) const {
    if (task_.kind == MoveKind::rapid && task_.options.rapid == RapidMode::dogleg) return false;
    const Motion motion(from, to);
    const Vec3 along = to.tip - from.tip;
    if (!motion.is_defined() || along.squaredNorm() <= 0) return false;
    const Pose there = motion.at(std::clamp((pose.tip - from.tip).dot(along) / along.squaredNorm(), 0.0, 1.0));
    return (there.tip - pose.tip).norm() <= kStraight_mm && (there.axis - pose.axis).norm() <= kStraightAxis;
  }

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

  static Pose lifted(const Pose& pose, double lift) { return {pose.tip + lift * pose.axis, pose.axis}; }

  static BridgePose stop(const Pose& before, const Pose& after, double lift, double depth) {
    return {{after, Strategy::axis, lift, 1}, before, depth};
  }

  const BridgeTask& task_;
};

}  // namespace

std::optional<std::vector<BridgePose>> bridge(const Pose& from, const Pose& to, const BridgeTask& task) {
  Bridger bridger(task);
  if (bridger.is_clean(from, to)) return std::vector<BridgePose>{};
  if (task.kind == MoveKind::rapid && task.rapid_clearance_mm > 0) {
    if (auto way = bridger.over(from, to, task.rapid_clearance_mm)) return way;
  }
  std::vector<BridgePose> way;
  if (!bridger.halve(from, to, kLevels, way)) return bridger.over(from, to, 0);
  bridger.leave_out_needless(from, to, way);
  return way;
}

}  // namespace gouge
