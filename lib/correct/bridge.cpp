#include "lib/correct/bridge.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/correct/bridger.h"

namespace gouge {
namespace {

constexpr double kFirstLift_mm = 0.25;
constexpr double kLiftGrowth = 1.4;
constexpr double kGap_mm = 0.02;      // how well the worst instant of a gouging motion is found
constexpr double kStraight_mm = 1e-3;  // how far off its neighbours' straight way a position may be left out
constexpr double kStraightAxis = 1e-5;
constexpr int kBisections = 14;            // to find where the programmed motion stops being clean
constexpr double kShortest_mm = 0.01;      // of a stretch of the programmed motion that is worth a position

Pose lifted(const Pose& pose, double lift) {
  return {pose.tip + lift * pose.axis, pose.axis};
}

BridgePose stop(const Pose& before, const Pose& after, double lift, double depth) {
  return {{after, Strategy::axis, lift, lift > 0 ? 1 : 0}, before, depth};
}

}  // namespace

std::optional<BridgeNodes> Bridger::route(const BridgeNode& u, const BridgeNode& v, int level, bool keeps) {
  if (keeps && task_.programmed != nullptr) {
    if (auto kept = along_programmed(u, v, level)) return kept;
  }
  return halve(u, v, level, keeps);
}

std::optional<BridgeNodes> Bridger::halve(const BridgeNode& u, const BridgeNode& v, int level, bool keeps) {
  const Motion motion = motion_between(u.pose(), v.pose());
  if (!motion.is_defined()) return std::nullopt;
  const MoveVerdict verdict = check(motion);
  if (verdict.state == MoveState::clean) return BridgeNodes{};
  if (verdict.state != MoveState::gouge) return std::nullopt;
  const double t = verdict.witness ? verdict.witness->t : 0;
  if (level == 0 || ++count_ > kMostPositions || t <= 0 || t >= 1) return std::nullopt;
  BridgeNode node;
  node.stop.before = motion.at(t);
  node.stop.depth_before_mm = verdict.depth_mm;
  node.t = u.t + t * (v.t - u.t);
  const FreedPose freed = free_pose(task_.strategy, node.stop.before, verdict.depth_mm, task_.kind, *task_.tool,
                                    *task_.checker, task_.limits, task_.largest_side_mm);
  if (!freed.corrected) return std::nullopt;
  node.stop.corrected = *freed.corrected;
  auto before = route(u, node, level - 1, keeps);
  if (!before) return std::nullopt;
  auto after = route(node, v, level - 1, keeps);
  if (!after) return std::nullopt;
  before->push_back(node);
  before->insert(before->end(), after->begin(), after->end());
  return before;
}

/// Between two positions of which one at least is off the programmed motion: holds on that motion, as far from them
/// as it is clean. Nothing where none is worth it.
std::optional<BridgeNodes> Bridger::along_programmed(const BridgeNode& u, const BridgeNode& v, int level) {
  const double off_u = off_mm(u), off_v = off_mm(v);
  if (std::max(off_u, off_v) <= task_.keeps_to_mm || level == 0) return std::nullopt;
  const double way = (task_.programmed->at(v.t).tip - task_.programmed->at(u.t).tip).norm();
  if (way < kShortest_mm) return std::nullopt;
  // From a clean instant towards each end that is off. An end that is on the motion is that instant.
  double clean_t = 0.5 * (u.t + v.t);
  if (off_u <= task_.keeps_to_mm) clean_t = u.t;
  if (off_v <= task_.keeps_to_mm) clean_t = v.t;
  if (!is_free_programmed(clean_t)) return std::nullopt;
  const double first = off_u <= task_.keeps_to_mm ? u.t : last_clean(clean_t, u.t);
  const double last = off_v <= task_.keeps_to_mm ? v.t : last_clean(clean_t, v.t);
  // A straight way from u to v leaves the motion by a share of how far its ends are off.
  const double span = v.t - u.t;
  const auto left_by = [&](double t) { return ((v.t - t) * off_u + (t - u.t) * off_v) / span; };
  BridgeNodes holds;
  if (first > u.t && left_by(first) > task_.keeps_to_mm) holds.push_back(hold(first));
  if (last < v.t && last > first && left_by(last) > task_.keeps_to_mm) holds.push_back(hold(last));
  if (holds.empty()) return std::nullopt;
  return joined(u, v, std::move(holds), level);
}

/// The way over the holds; a hold from which the rest is not reached moves back along the motion.
std::optional<BridgeNodes> Bridger::joined(const BridgeNode& u, const BridgeNode& v, BridgeNodes holds, int level) {
  const double first = holds.front().t, last = holds.back().t;
  const bool has_both = holds.size() == 2;
  const bool is_leaving = !has_both && off_mm(u) > task_.keeps_to_mm;
  for (const double back : {0.0, 1.0 / 16, 1.0 / 4, 1.0 / 2}) {
    if (has_both) {
      holds = {hold(first + 0.5 * back * (last - first)), hold(last - 0.5 * back * (last - first))};
    } else {
      holds = {hold(is_leaving ? first + back * (v.t - first) : last - back * (last - u.t))};
    }
    BridgeNodes all;
    BridgeNode from = u;
    bool is_found = true;
    for (std::size_t k = 0; k <= holds.size() && is_found; ++k) {
      const BridgeNode& to = k < holds.size() ? holds[k] : v;
      const auto part = back > 0 ? halve(from, to, level - 1, false) : route(from, to, level - 1, true);
      is_found = part.has_value();
      if (!is_found) break;
      all.insert(all.end(), part->begin(), part->end());
      if (k < holds.size()) all.push_back(to);
      from = to;
    }
    if (is_found) return all;
  }
  return std::nullopt;
}

BridgeNode Bridger::hold(double t) const {
  const Pose pose = task_.programmed->at(t);
  return {stop(pose, pose, 0, 0), t};
}

double Bridger::off_mm(const BridgeNode& node) const {
  return (node.pose().tip - task_.programmed->at(node.t).tip).norm();
}

bool Bridger::is_clean_programmed(double t0, double t1) const {
  return is_clean(task_.programmed->at(std::min(t0, t1)), task_.programmed->at(std::max(t0, t1)));
}

bool Bridger::is_free_programmed(double t) const {
  const Pose pose = task_.programmed->at(t);
  return is_clean(pose, pose) && task_.checker->side_of(pose, *task_.tool) != Side::inside;
}

double Bridger::last_clean(double from, double towards) const {
  double good = from, bad = towards;
  for (int k = 0; k < kBisections; ++k) {
    const double t = 0.5 * (good + bad);
    if ((task_.programmed->at(good).tip - task_.programmed->at(bad).tip).norm() < kShortest_mm) break;
    (is_clean_programmed(good, t) ? good : bad) = t;
  }
  return good;
}

/// The crossing keeps `clearance_mm`; what leads up to it and down again does not.
std::optional<BridgeNodes> Bridger::over(const BridgeNode& from, const BridgeNode& to, double clearance_mm) {
  const MoveVerdict direct = check(motion_between(from.pose(), to.pose()));
  for (double lift = kFirstLift_mm; lift <= task_.limits.largest_shift_mm; lift *= kLiftGrowth) {
    const Pose up = lifted(from.pose(), lift), down = lifted(to.pose(), lift);
    if (is_clean(from.pose(), up) && is_clean(up, down, clearance_mm) && is_clean(down, to.pose())) {
      return BridgeNodes{{stop(from.pose(), up, lift, direct.depth_mm), from.t},
                         {stop(to.pose(), down, lift, direct.depth_mm), to.t}};
    }
  }
  return std::nullopt;
}

/// Retracts where the programmed motion stops being clean, and comes down where it is clean again.
std::optional<BridgeNodes> Bridger::over_gouge(const BridgeNode& u, const BridgeNode& v) {
  if (task_.programmed == nullptr || task_.kind == MoveKind::rapid) return over(u, v, 0);
  BridgeNode from = u, to = v;
  BridgeNodes way;
  const bool is_up = off_mm(u) <= task_.keeps_to_mm && is_free_programmed(u.t);
  const bool is_down = off_mm(v) <= task_.keeps_to_mm && is_free_programmed(v.t);
  if (is_up) from = hold(last_clean(u.t, v.t));
  if (is_down) to = hold(last_clean(v.t, u.t));
  if (to.t > from.t) {
    const auto middle = over(from, to, 0);
    if (middle && is_clean(u.pose(), from.pose()) && is_clean(to.pose(), v.pose())) {
      if (from.t > u.t) way.push_back(from);
      way.insert(way.end(), middle->begin(), middle->end());
      if (to.t < v.t) way.push_back(to);
      return way;
    }
  }
  return over(u, v, 0);
}

void Bridger::leave_out_needless(const Pose& from, const Pose& to, BridgeNodes& way) const {
  BridgeNodes kept;
  std::vector<Pose> left_out;  // since the last one kept
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Pose& last = kept.empty() ? from : kept.back().pose();
    const Pose& next = k + 1 < way.size() ? way[k + 1].pose() : to;
    left_out.push_back(way[k].pose());
    const bool is_straight = std::all_of(left_out.begin(), left_out.end(),
                                         [&](const Pose& pose) { return is_on_the_way(last, next, pose); });
    if (is_straight && is_clean(last, next)) continue;
    kept.push_back(way[k]);
    left_out.clear();
  }
  way = std::move(kept);
}

bool Bridger::is_clean(const Pose& from, const Pose& to, double clearance_mm) const {
  CheckOptions options = task_.options;
  options.near_miss_mm = std::max(options.near_miss_mm, clearance_mm);
  return task_.checker->is_clean(motion_between(from, to), task_.kind, *task_.tool, options, true);
}

// Where a dogleg runs straight is not asked: all its positions stay.
bool Bridger::is_on_the_way(const Pose& from, const Pose& to, const Pose& pose) const {
  if (task_.kind == MoveKind::rapid && task_.options.rapid == RapidMode::dogleg) return false;
  const Motion motion(from, to);
  const Vec3 along = to.tip - from.tip;
  if (!motion.is_defined() || along.squaredNorm() <= 0) return false;
  const Pose there = motion.at(std::clamp((pose.tip - from.tip).dot(along) / along.squaredNorm(), 0.0, 1.0));
  return (there.tip - pose.tip).norm() <= kStraight_mm && (there.axis - pose.axis).norm() <= kStraightAxis;
}

Motion Bridger::motion_between(const Pose& from, const Pose& to) const {
  return Motion(from, to, task_.kind == MoveKind::rapid && task_.options.rapid == RapidMode::dogleg);
}

MoveVerdict Bridger::check(const Motion& motion) const {
  CheckOptions options = task_.options;
  options.gouge_gap_mm = kGap_mm;
  return task_.checker->check(motion, task_.kind, *task_.tool, options, true);
}

std::optional<BridgeNodes> Bridger::find(const BridgeNode& u, const BridgeNode& v) {
  if (task_.checker->side_of(u.pose(), *task_.tool) == Side::inside) return std::nullopt;
  const bool is_rapid = task_.kind == MoveKind::rapid;
  if (is_rapid || task_.programmed == nullptr) {
    if (is_clean(u.pose(), v.pose())) return BridgeNodes{};
    if (is_rapid && task_.rapid_clearance_mm > 0) {
      if (auto way = over(u, v, task_.rapid_clearance_mm)) return way;
    }
  }
  for (const bool keeps : {true, false}) {
    if (!keeps && task_.programmed == nullptr) break;
    count_ = 0;
    if (auto way = route(u, v, kLevels, keeps && !is_rapid)) {
      leave_out_needless(u.pose(), v.pose(), *way);
      return way;
    }
    if (is_rapid) break;
  }
  return over_gouge(u, v);
}

std::optional<std::vector<BridgePose>> bridge(const Pose& from, const Pose& to, const BridgeTask& task) {
  Bridger bridger(task);
  const auto way = bridger.find({stop(from, from, 0, 0), 0}, {stop(to, to, 0, 0), 1});
  if (!way) return std::nullopt;
  std::vector<BridgePose> poses;
  for (const BridgeNode& node : *way) poses.push_back(node.stop);
  return poses;
}

}  // namespace gouge
