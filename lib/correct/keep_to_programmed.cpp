#include <algorithm>
#include <array>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/correct/link_finder.h"

namespace gouge {
namespace {

// Distances from the end of a clean interval at which a path may leave it; they are tried in this order.
constexpr std::array kBack_mm{0.02, 0.1, 0.5, 2.0, 8.0};
constexpr std::array kBackShares{1.0 / 16, 1.0 / 4, 1.0 / 2};  // shares of both intervals, for paths over corrected
                                                               // positions
constexpr double kShortest_mm = 0.01;                          // minimum length of an interval for which a position is
                                                               // added

}  // namespace

std::optional<LinkNodes> LinkFinder::keep_to_programmed(const LinkNode& u, const LinkNode& v) {
  clean_ = clean_programmed();
  while (!clean_.empty()) {
    LinkNodes waypoints;
    const std::optional<std::size_t> failed = chain(u, v, waypoints);
    if (!failed) {
      leave_out_holds(u, v, waypoints);
      return waypoints;
    }
    drop_interval(*failed);
  }
  return std::nullopt;
}

/// Returns the clean intervals that are long enough for a position and in which the tool is outside. They are clean to
/// the tolerance without the resolution. So a path from one of their ends is not too deep at this end.
std::vector<TimeInterval> LinkFinder::clean_programmed() const {
  const Motion& motion = *task_.programmed;
  CheckOptions options = task_.options;
  options.tolerance_mm = std::max(0.0, options.tolerance_mm - options.resolution_mm);
  std::vector<TimeInterval> clean = find_clean_intervals(motion, [&](double first, double last) {
    return task_.checker->is_clean(motion_between(motion.at(first), motion.at(last)), task_.kind, *task_.tool, options,
                                   true);
  });
  std::erase_if(clean, [&](const TimeInterval& interval) {
    const Pose first = motion.at(interval.first), last = motion.at(interval.last);
    const bool is_end = interval.first <= 0 || interval.last >= 1;
    return (!is_end && (first.tip - last.tip).norm() < kShortest_mm) ||
           task_.checker->side_of(first, *task_.tool) == Side::inside;
  });
  return clean;
}

/// Finds the path over all clean intervals: along each of them, and across the gaps between them. Returns the gap that
/// cannot be crossed, if there is one. Gap k ends at interval k.
std::optional<std::size_t> LinkFinder::chain(const LinkNode& u, const LinkNode& v, LinkNodes& waypoints) {
  GapEnd left{u, {u.t, u.t}, true};
  for (std::size_t k = 0; k <= clean_.size(); ++k) {
    GapEnd right{v, {v.t, v.t}, true};
    if (k < clean_.size()) right = {hold(clean_[k].first), clean_[k], false};
    const auto across = cross(left, right);
    if (!across) return k;
    if (!left.is_fixed) {
      waypoints.push_back(hold(left.room.first));
      if (left.room.last > left.room.first) waypoints.push_back(hold(left.room.last));
    }
    waypoints.insert(waypoints.end(), across->begin(), across->end());
    left = right;
  }
  return std::nullopt;
}

/// Finds a straight path from one clean interval to the next, which may leave both ends of the gap where it stays near
/// the programmed motion. It shortens both intervals as cross() does.
bool LinkFinder::cross_straight(GapEnd& left, GapEnd& right) const {
  const double length = (task_.programmed->at(1).tip - task_.programmed->at(0).tip).norm();
  const auto try_at = [&](double left_t, double right_t) {
    const LinkNode from = left.is_fixed ? left.node : hold(left_t), to = right.is_fixed ? right.node : hold(right_t);
    if (!stays_near(from, to) || !is_clean(from.pose(), to.pose())) return false;
    left.room.last = left_t;
    right.room.first = right_t;
    return true;
  };
  if (try_at(left.room.last, right.room.first)) return true;
  for (const double back_mm : kBack_mm) {
    const double back = length > back_mm ? back_mm / length : 1;
    const double left_t = std::max(left.room.first, left.room.last - back);
    const double right_t = std::min(right.room.last, right.room.first + back);
    if (try_at(left_t, right.room.first) || try_at(left.room.last, right_t) || try_at(left_t, right_t)) return true;
  }
  return false;
}

/// Finds a path from one clean interval to the next. It shortens both to the part that the path leaves of them.
std::optional<LinkNodes> LinkFinder::cross(GapEnd& left, GapEnd& right) {
  double tried_left = left.room.last, tried_right = right.room.first;
  std::optional<LinkNodes> waypoints;
  const auto try_at = [&](double left_t, double right_t, Search search) {
    waypoints = link_ends(left, right, left_t, right_t, search);
    if (!waypoints) return false;
    left.room.last = left_t;
    right.room.first = right_t;
    return true;
  };
  if (cross_straight(left, right)) return LinkNodes{};
  if (try_at(tried_left, tried_right, Search::thorough)) return waypoints;
  const double length = (task_.programmed->at(1).tip - task_.programmed->at(0).tip).norm();
  for (const double back_mm : kBack_mm) {
    const double back = length > back_mm ? back_mm / length : 1;
    const double left_t = std::max(left.room.first, left.room.last - back);
    const double right_t = std::min(right.room.last, right.room.first + back);
    const bool is_left_new = left_t<tried_left, is_right_new = right_t> tried_right;
    if (is_left_new && try_at(left_t, right.room.first, Search::simple)) return waypoints;
    if (is_right_new && try_at(left.room.last, right_t, Search::simple)) return waypoints;
    if (is_left_new && is_right_new && try_at(left_t, right_t, Search::simple)) return waypoints;
    tried_left = left_t;
    tried_right = right_t;
  }
  if (left.is_fixed && right.is_fixed) return std::nullopt;
  for (const double share : kBackShares) {
    const double left_t = left.room.last - share * (left.room.last - left.room.first);
    const double right_t = right.room.first + share * (right.room.last - right.room.first);
    if (try_at(left_t, right_t, Search::thorough)) return waypoints;
  }
  return std::nullopt;
}

std::optional<LinkNodes> LinkFinder::link_ends(const GapEnd& left, const GapEnd& right, double left_t, double right_t,
                                               Search search) {
  const LinkNode from = left.is_fixed ? left.node : hold(left_t);
  const LinkNode to = right.is_fixed ? right.node : hold(right_t);
  if (is_clean(from.pose(), to.pose())) return LinkNodes{};
  count_ = 0;
  auto waypoints = search == Search::thorough ? halve(from, to, kLevels) : corner(from, to, 0);
  if (!waypoints) waypoints = over(from, to, 0);
  return waypoints;
}

/// Drops the shorter of the two intervals at a gap that no path crosses.
void LinkFinder::drop_interval(std::size_t gap) {
  const auto length = [&](std::size_t k) { return clean_[k].last - clean_[k].first; };
  const bool has_left = gap > 0, has_right = gap < clean_.size();
  const bool is_left = has_left && (!has_right || length(gap - 1) < length(gap));
  clean_.erase(clean_.begin() + static_cast<std::ptrdiff_t>(is_left ? gap - 1 : gap));
}

/// Removes positions on the programmed motion without which the path stays clean and as near to the motion.
void LinkFinder::leave_out_holds(const LinkNode& u, const LinkNode& v, LinkNodes& waypoints) const {
  LinkNodes kept;
  for (std::size_t k = 0; k < waypoints.size(); ++k) {
    const LinkNode& last = kept.empty() ? u : kept.back();
    const LinkNode& next = k + 1 < waypoints.size() ? waypoints[k + 1] : v;
    const bool is_needless =
        is_on_programmed(waypoints[k]) && stays_near(last, next) && is_clean(last.pose(), next.pose());
    if (!is_needless) kept.push_back(waypoints[k]);
  }
  waypoints = std::move(kept);
}

/// Returns whether the straight path stays near the programmed motion wherever that is clean. Its deviation is a mean
/// of the deviations at its ends, so the ends of the clean intervals represent all instants.
bool LinkFinder::stays_near(const LinkNode& from, const LinkNode& to) const {
  const Vec3 off_from = offset_mm(from), off_to = offset_mm(to);
  const double span = to.t - from.t;
  const auto is_near = [&](double t) {
    const double share = span > 0 ? (t - from.t) / span : 0;
    return ((1 - share) * off_from + share * off_to).norm() <= task_.keeps_to_mm;
  };
  return std::all_of(clean_.begin(), clean_.end(), [&](const TimeInterval& interval) {
    const double first = std::max(interval.first, from.t), last = std::min(interval.last, to.t);
    return first >= last || (is_near(first) && is_near(last));
  });
}

LinkNode LinkFinder::hold(double t) const {
  const Pose pose = task_.programmed->at(t);
  return {link_stop(pose, pose, 0, 0), t};
}

Vec3 LinkFinder::offset_mm(const LinkNode& node) const { return node.pose().tip - task_.programmed->at(node.t).tip; }

bool LinkFinder::is_on_programmed(const LinkNode& node) const {
  return offset_mm(node).norm() <= Tolerance::kSamePoint_mm;
}

}  // namespace gouge
