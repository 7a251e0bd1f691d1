#include "lib/path/programmed_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/path/chords.h"
#include "lib/path/path_info.h"

namespace gouge {
namespace {

constexpr double kAxisError_mm = 0.01;
constexpr double kTimesNearest = 2;

/// One straight piece of a programmed motion. Its axis turns evenly on the great circle.
struct Stretch {
  const Pose& from;
  const Pose& to;

  /// Share of the piece, before it is kept within it, and squared distance of the line there.
  [[nodiscard]] std::pair<double, double> nearest_on_line(const Vec3& tip) const {
    const Vec3 along = to.tip - from.tip, off = tip - from.tip;
    const double length2 = along.squaredNorm();
    if (!(length2 > 0)) return {0, off.squaredNorm()};
    const double t = off.dot(along) / length2;
    return {t, (off - t * along).squaredNorm()};
  }

  [[nodiscard]] double distance(const Vec3& tip) const {
    const double t = std::clamp(nearest_on_line(tip).first, 0.0, 1.0);
    return (tip - (from.tip + t * (to.tip - from.tip))).norm();
  }

  /// Of its axes at places within `reach_mm` of the position, the one nearest to the position's. Requires that there
  /// is such a place.
  [[nodiscard]] Vec3 nearest_axis(const Pose& pose, double reach_mm) const {
    const auto [t, distance2] = nearest_on_line(pose.tip);
    const double length = (to.tip - from.tip).norm();
    const double half = std::sqrt(std::max(reach_mm * reach_mm - distance2, 0.0));
    const double share = length > 0 ? half / length : 1;
    const double first = std::clamp(t - share, 0.0, 1.0), last = std::clamp(t + share, 0.0, 1.0);
    const double angle = angle_between_rad(from.axis, to.axis);
    if (!(angle > 0)) return to.axis;
    const Vec3 ahead = (to.axis - to.axis.dot(from.axis) * from.axis).normalized();
    const double best = std::atan2(pose.axis.dot(ahead), pose.axis.dot(from.axis)) / angle;
    return axis_between(from.axis, to.axis, std::clamp(best, first, last));
  }
};

Vec3 axis_at_nearest(const std::vector<Pose>& motion, const Pose& pose) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < motion.size(); ++i)
    nearest = std::min(nearest, Stretch{motion[i], motion[i + 1]}.distance(pose.tip));
  const double reach_mm = kTimesNearest * nearest + kAxisError_mm;
  Vec3 best = motion.back().axis;
  double least_rad = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
    const Stretch stretch{motion[i], motion[i + 1]};
    if (stretch.distance(pose.tip) > reach_mm) continue;
    const Vec3 axis = stretch.nearest_axis(pose, reach_mm);
    const double angle = angle_between_rad(axis, pose.axis);
    if (!(angle < least_rad)) continue;
    least_rad = angle;
    best = axis;
  }
  return best;
}

}  // namespace

std::vector<Vec3> programmed_axes(const Toolpath& before, const Toolpath& after,
                                  const std::vector<std::size_t>& origins) {
  std::vector<Vec3> axes(after.moves.size());
  std::vector<Pose> motion;
  std::size_t of_move = kNone;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const std::size_t origin = origins[k];
    const Move& programmed = before.moves[origin];
    const bool is_inserted = k + 1 < axes.size() && origins[k + 1] == origin;
    axes[k] = programmed.end.axis;
    if (!is_inserted || !programmed.has_start) continue;
    if (origin != of_move) {
      motion = chords_of(before, origin, kAxisError_mm);
      motion.insert(motion.begin(), before.start_of(origin));
      of_move = origin;
    }
    axes[k] = axis_at_nearest(motion, after.moves[k].end);
  }
  return axes;
}

}  // namespace gouge
