#include "lib/correct/link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/correct/lifts.h"
#include "lib/correct/link_finder.h"

namespace gouge {
namespace {

constexpr double kGap_mm = 0.02;     // accuracy of the worst instant of a gouging motion
constexpr double kAirMargin = 1.05;  // factor of the clearance at positions, so that the rapid between them keeps the
                                     // full clearance
constexpr int kHalvings = 6;

Pose retracted(const Pose& pose, double lift) { return {pose.tip + lift * pose.axis, pose.axis}; }

bool is_same_place(const Pose& a, const Pose& b) {
  return (a.tip - b.tip).norm() <= Tolerance::kFilePoint_mm && (a.axis - b.axis).norm() <= Tolerance::kFileAxis;
}

}  // namespace

LinkPose link_stop(const Pose& before, const Pose& after, double lift_mm, double depth_mm) {
  return {{after, Strategy::axis, lift_mm, lift_mm > 0 ? 1 : 0}, before, depth_mm};
}

std::optional<LinkNodes> LinkFinder::halve(const LinkNode& u, const LinkNode& v, int level) {
  const Motion motion = motion_between(u.pose(), v.pose());
  if (!motion.is_defined()) return std::nullopt;
  const MoveVerdict verdict = check(motion);
  if (verdict.state == MoveState::clean) return LinkNodes{};
  const bool is_near = air_mm_ > 0 && verdict.state == MoveState::near_miss;
  if (verdict.state != MoveState::gouge && !is_near) return std::nullopt;
  const double t = verdict.witness ? verdict.witness->t : 0;
  if (level == 0 || ++count_ > kMaxPositions || t <= 0 || t >= 1) return std::nullopt;
  if (auto waypoints = corner(u, v, verdict.depth_mm)) return waypoints;
  LinkNode node;
  node.stop.before = motion.with(verdict.witness ? verdict.witness->turn : std::nullopt).at(t);
  node.stop.depth_before_mm = verdict.depth_mm;
  node.t = u.t + t * (v.t - u.t);
  // A rapid need not stay over a cut, so it goes the shortest way.
  const bool is_lift_asked = task_.strategy == Strategy::axis || task_.strategy == Strategy::direction;
  const bool is_shortest = task_.kind == MoveKind::rapid && !is_lift_asked;
  const Strategy strategy = is_shortest ? Strategy::normal : task_.strategy;
  const FreedPose freed = free_pose(strategy, node.stop.before, verdict.depth_mm + air_mm_, task_.kind, *task_.tool,
                                    *task_.checker, limits(), task_.largest_side_mm);
  if (!freed.corrected) return std::nullopt;
  node.stop.corrected = *freed.corrected;
  auto before = halve(u, node, level - 1);
  if (!before) return std::nullopt;
  auto after = halve(node, v, level - 1);
  if (!after) return std::nullopt;
  before->push_back(node);
  before->insert(before->end(), after->begin(), after->end());
  return before;
}

/// Leads away from the programmed motion at one end of the gap, to the deviation of the other end. From there on the
/// path is parallel to the motion.
std::optional<LinkNodes> LinkFinder::corner(const LinkNode& u, const LinkNode& v, double depth_mm) {
  if (task_.programmed == nullptr) return std::nullopt;
  const Vec3 off_u = offset_mm(u), off_v = offset_mm(v);
  const bool is_at_u = off_v.squaredNorm() > off_u.squaredNorm();
  const LinkNode &near = is_at_u ? u : v, &far = is_at_u ? v : u;
  const Vec3& off = is_at_u ? off_v : off_u;
  if ((off_u - off_v).norm() <= task_.keeps_to_mm) return std::nullopt;
  const Pose on = task_.programmed->at(near.t);
  // If the deviation is a lift, the new one is along the axis of its own instant.
  const double lift = off.dot(far.pose().axis);
  const bool is_lift = (off - lift * far.pose().axis).norm() <= Tolerance::kFilePoint_mm;
  const Pose turn{on.tip + (is_lift ? Vec3(lift * near.pose().axis) : off), near.pose().axis};
  if (!is_clean(near.pose(), turn) || !is_clean(turn, far.pose())) return std::nullopt;
  return LinkNodes{{link_stop(on, turn, off.norm(), depth_mm), near.t}};
}

PoseLimits LinkFinder::limits() const {
  PoseLimits limits = task_.limits;
  const double aim = -kAirMargin * air_mm_;
  if (air_mm_ > 0) limits.aim = {aim, aim, aim};
  return limits;
}

/// Returns the lifts of both ends that bring them to one height, for a rapid over stock with a fixed axis. Otherwise no
/// lifts.
std::array<double, 2> LinkFinder::lifts_to_level(const Pose& from, const Pose& to) const {
  const bool is_level = task_.kind == MoveKind::rapid && task_.checker->has_stock() &&
                        (from.axis - to.axis).norm() <= Tolerance::kFileAxis;
  if (!is_level) return {0, 0};
  const double rise = (to.tip - from.tip).dot(from.axis);
  return {std::max(0.0, rise), std::max(0.0, -rise)};
}

/// Returns the lifts to try, in increasing order. A rapid may go over all stock, since no cut is shifted.
std::vector<double> LinkFinder::lifts_of_way(const Pose& from, const Pose& to) const {
  const double most = task_.limits.largest_shift_mm;
  if (task_.kind != MoveKind::rapid || !task_.checker->has_stock()) return lifts_up_to(most);
  std::vector<double> lifts = lifts_up_to(std::max(most, task_.checker->lift_over_stock_mm(from, to)));
  lifts.insert(lifts.begin(), 0);
  return lifts;
}

/// Finds a path up, across and down. The crossing keeps `clearance_mm`; the ways up and down do not. Lifts grow. If
/// only the largest lift is free, halving finds the smallest free lift between it and the one before; with stock it does
/// so for every lift. If no lift is free for a rapid, lifts in between are tried.
std::optional<LinkNodes> LinkFinder::over(const LinkNode& from, const LinkNode& to, double clearance_mm) {
  const bool is_rapid = task_.kind == MoveKind::rapid, has_stock = task_.checker->has_stock();
  const auto [rise_from, rise_to] = lifts_to_level(from.pose(), to.pose());
  const auto is_free = [&, rise_from = rise_from, rise_to = rise_to](double lift) {
    const Pose up = retracted(from.pose(), rise_from + lift), down = retracted(to.pose(), rise_to + lift);
    is_blocked_ = !is_clean(from.pose(), up) || !is_clean(down, to.pose());
    return !is_blocked_ && is_clean(up, down, clearance_mm);
  };
  const auto way = [&, rise_from = rise_from, rise_to = rise_to](double lift) {
    const double depth = check(motion_between(from.pose(), to.pose())).depth_mm;
    // A rapid need not rise at an end from or to which the crossing keeps the clearance.
    const bool may_be_direct = is_rapid && !has_stock;
    const bool is_end_direct =
        may_be_direct && is_clean(retracted(from.pose(), rise_from + lift), to.pose(), clearance_mm);
    const bool is_start_direct =
        may_be_direct && !is_end_direct && is_clean(from.pose(), retracted(to.pose(), rise_to + lift), clearance_mm);
    LinkNodes nodes;
    for (const auto& [node, rise] : {std::pair(&from, rise_from + lift), std::pair(&to, rise_to + lift)}) {
      const Pose stop = retracted(node->pose(), rise);
      const bool is_direct = node == &from ? is_start_direct : is_end_direct;
      if (rise > 0 && !is_direct && !is_same_place(stop, to.pose()))
        nodes.push_back({link_stop(node->pose(), stop, rise, depth), node->t});
    }
    return nodes;
  };
  const std::vector<double> lifts = lifts_of_way(from.pose(), to.pose());
  for (std::size_t k = 0; k < lifts.size(); ++k) {
    if (is_free(lifts[k])) {
      double low = k > 0 ? lifts[k - 1] : 0, high = lifts[k];
      const bool is_narrowed = k > 0 && (has_stock || k + 1 == lifts.size());
      for (int step = 0; is_narrowed && step < kHalvings; ++step) {
        const double middle = 0.5 * (low + high);
        (is_free(middle) ? high : low) = middle;
      }
      return way(high);
    }
    // An obstacle to a straight lift is also an obstacle to every longer lift.
    if (is_blocked_ && (!is_rapid || has_stock)) return std::nullopt;
  }
  for (std::size_t k = 0; is_rapid && k + 1 < lifts.size(); ++k) {
    const double between = has_stock ? 0.5 * (lifts[k] + lifts[k + 1]) : std::sqrt(lifts[k] * lifts[k + 1]);
    if (is_free(between)) return way(between);
  }
  return std::nullopt;
}

void LinkFinder::leave_out_needless(const Pose& from, const Pose& to, LinkNodes& waypoints) const {
  LinkNodes kept;
  std::vector<Pose> left_out;  // positions that were removed since the last kept one
  for (std::size_t k = 0; k < waypoints.size(); ++k) {
    const Pose& last = kept.empty() ? from : kept.back().pose();
    const Pose& next = k + 1 < waypoints.size() ? waypoints[k + 1].pose() : to;
    left_out.push_back(waypoints[k].pose());
    const bool is_straight =
        std::all_of(left_out.begin(), left_out.end(), [&](const Pose& pose) { return is_between(last, next, pose); });
    if (is_straight && is_clean(last, next)) continue;
    kept.push_back(waypoints[k]);
    left_out.clear();
  }
  waypoints = std::move(kept);
}

bool LinkFinder::is_clean(const Pose& from, const Pose& to, double clearance_mm) const {
  CheckOptions options = task_.options;
  const double room = std::max(clearance_mm, air_mm_);
  options.near_miss_mm = std::max(options.near_miss_mm, room);
  return checker_with(room).is_clean(motion_between(from, to), task_.kind, *task_.tool, options, true);
}

// Returns whether a pose lies on the straight path. The parts of a dogleg are not searched: all its positions stay.
bool LinkFinder::is_between(const Pose& from, const Pose& to, const Pose& pose) const {
  if (task_.kind == MoveKind::rapid && task_.options.law.rapid() == RapidMode::dogleg) return false;
  const Motion motion = motion_between(from, to);
  const Vec3 along = to.tip - from.tip;
  if (!motion.is_defined() || along.squaredNorm() <= 0) return false;
  const Pose there = motion.at(std::clamp((pose.tip - from.tip).dot(along) / along.squaredNorm(), 0.0, 1.0));
  return is_same_place(there, pose);
}

Motion LinkFinder::motion_between(const Pose& from, const Pose& to) const {
  return task_.options.law.between(from, to, task_.kind);
}

MoveVerdict LinkFinder::check(const Motion& motion) const {
  CheckOptions options = task_.options;
  options.gouge_gap_mm = kGap_mm;
  options.near_miss_mm = std::max(options.near_miss_mm, air_mm_);
  return checker_with(air_mm_).check(motion, task_.kind, *task_.tool, options, true);
}

MotionChecker LinkFinder::checker_with(double room_mm) const {
  return task_.kind == MoveKind::rapid && room_mm > 0 ? task_.checker->keeping_room() : *task_.checker;
}

std::optional<LinkNodes> LinkFinder::find(const LinkNode& u, const LinkNode& v) {
  if (task_.checker->side_of(u.pose(), *task_.tool) == Side::inside) return std::nullopt;
  if (task_.kind == MoveKind::rapid) return find_rapid(u, v);
  if (task_.programmed == nullptr && is_clean(u.pose(), v.pose())) return LinkNodes{};
  auto waypoints = find_feed(u, v);
  if (!waypoints) return over(u, v, 0);
  leave_out_needless(u.pose(), v.pose(), *waypoints);
  return waypoints;
}

std::optional<LinkNodes> LinkFinder::find_rapid(const LinkNode& u, const LinkNode& v) {
  const double clearance = task_.rapid_clearance_mm;
  if (is_clean(u.pose(), v.pose(), clearance)) return LinkNodes{};
  const bool is_straight_clean = clearance > 0 && is_clean(u.pose(), v.pose());
  if (is_straight_clean && (task_.is_free_as_programmed || keeps_beyond_contacts(u.pose(), v.pose())))
    return LinkNodes{};
  if (clearance > 0 || task_.checker->has_stock()) {
    if (auto waypoints = over(u, v, clearance)) return waypoints;
    // No way leads out of stock in which the tool is at an end.
    if (is_blocked_ && task_.checker->has_stock()) return std::nullopt;
  }
  if (clearance > 0) {
    if (auto waypoints = round(u, v, clearance)) return waypoints;
  }
  if (is_straight_clean) return LinkNodes{};
  auto waypoints = round(u, v, 0);
  return waypoints ? waypoints : over(u, v, 0);
}

/// Finds a path past the worst instants, at a distance of `air_mm` from everything.
std::optional<LinkNodes> LinkFinder::round(const LinkNode& u, const LinkNode& v, double air_mm) {
  air_mm_ = air_mm;
  count_ = 0;
  auto waypoints = halve(u, v, kLevels);
  if (waypoints) leave_out_needless(u.pose(), v.pose(), *waypoints);
  air_mm_ = 0;
  return waypoints;
}

std::optional<LinkNodes> LinkFinder::find_feed(const LinkNode& u, const LinkNode& v) {
  if (task_.programmed != nullptr) {
    const bool is_near = std::max(offset_mm(u).norm(), offset_mm(v).norm()) <= task_.keeps_to_mm;
    if (is_near && is_clean(u.pose(), v.pose())) return LinkNodes{};
    if (auto waypoints = keep_to_programmed(u, v)) return waypoints;
  }
  count_ = 0;
  return halve(u, v, kLevels);
}

std::optional<std::vector<LinkPose>> link(const Pose& from, const Pose& to, const LinkTask& task) {
  LinkFinder link_finder(task);
  const auto waypoints = link_finder.find({link_stop(from, from, 0, 0), 0}, {link_stop(to, to, 0, 0), 1});
  if (!waypoints) return std::nullopt;
  std::vector<LinkPose> poses;
  for (const LinkNode& node : *waypoints) poses.push_back(node.stop);
  return poses;
}

}  // namespace gouge
