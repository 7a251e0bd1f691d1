#include "lib/correct/shift_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/contact/aims.h"
#include "lib/correct/free_pose.h"

namespace gouge {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kHeightShare = 0.2;
constexpr double kTooDeepShare = 0.5;
constexpr double kMostOfIt = 0.9;
constexpr double kSweepChange_rad = 0.2;
constexpr double kLeastRadius_mm = 1e-3;
constexpr int kShiftPlaces = 16;
constexpr double kNearby = 0.2;  // of the motion
constexpr int kNarrowings = 40;

Vec3 across(const Vec3& displacement, const Vec3& axis) { return displacement - displacement.dot(axis) * axis; }

class ArcShift {
 public:
  ArcShift(const ArcTask& task, const MotionChecker& checker)
      : task_(task), checker_(checker), options_(checker.options()) {
    is_full_ = (task.start.tip - task.end.tip).norm() <= Tolerance::kSamePoint_mm;
    options_.tolerance_mm *= kMotionAimShare;
    options_.near_miss_mm = 0;
  }

  [[nodiscard]] std::optional<PathArc> run() const {
    const bool keeps_axes = (task_.start.axis - task_.new_start.axis).norm() <= Tolerance::kExactDirection &&
                            (task_.end.axis - task_.new_end.axis).norm() <= Tolerance::kExactDirection;
    if (!keeps_axes || std::abs(task_.arc.sweep_rad) > kTurn + Tolerance::kRounding) return std::nullopt;
    const bool ends_meet = task_.new_start.tip == task_.new_end.tip;
    if (is_full_ != ends_meet) return std::nullopt;
    const Vec3 shift = 0.5 * (task_.new_start.tip - task_.start.tip + task_.new_end.tip - task_.end.tip);
    const Vec3 along = shift.dot(task_.arc.axis) * task_.arc.axis;
    for (const Vec3& displacement : {shift, along}) {
      const std::optional<PathArc> arc = about(task_.arc.center + displacement);
      if (arc && is_good(*arc)) return arc;
    }
    return std::nullopt;
  }

 private:
  // The arc about the point nearest to `center` that is equally far from both ends.
  [[nodiscard]] std::optional<PathArc> about(Vec3 center) const {
    const Vec3& axis = task_.arc.axis;
    const Vec3 &s = task_.new_start.tip, &e = task_.new_end.tip;
    const double rise = (e - s).dot(axis) - (task_.end.tip - task_.start.tip).dot(axis);
    if (std::abs(rise) > kHeightShare * checker_.options().tolerance_mm) return std::nullopt;
    PathArc arc = task_.arc;
    if (!is_full_) {
      const Vec3 chord = across(e - s, axis);
      const double length = chord.norm();
      if (!(length > kLeastRadius_mm)) return std::nullopt;
      const Vec3 middle = 0.5 * (s + e);
      center -= (center - middle).dot(chord) / (length * length) * chord;
    }
    const Vec3 from = across(s - center, axis), to = across(e - center, axis);
    if (!(from.norm() > kLeastRadius_mm)) return std::nullopt;
    arc.center = center;
    if (is_full_) return arc;
    const double sign = arc.sweep_rad < 0 ? -1 : 1;
    double sweep = sign * std::atan2(axis.dot(from.cross(to)), from.dot(to));
    if (sweep <= 0) sweep += kTurn;
    if (std::abs(sweep - std::abs(task_.arc.sweep_rad)) > kSweepChange_rad) return std::nullopt;
    arc.sweep_rad = sign * sweep;
    return arc;
  }

  [[nodiscard]] bool is_good(const PathArc& arc) const {
    const Motion motion = options_.law.along(task_.new_start, task_.new_end, arc);
    return checker_.is_clean(motion, task_.kind, *task_.tool, options_) && is_shift_allowed(motion);
  }

  [[nodiscard]] bool is_shift_allowed(const Motion& motion) const {
    const Motion before = options_.law.along(task_.start, task_.end, task_.arc);
    const double tolerance = checker_.options().tolerance_mm;
    int too_deep = 0;
    bool is_forced = true;
    for (int i = 0; i <= kShiftPlaces; ++i) {
      const double t = static_cast<double>(i) / kShiftPlaces;
      const Pose from = before.at(t), to = i == 0 || i == kShiftPlaces ? motion.at(t) : nearest(motion, t, from);
      const double depth = checker_.measure(from, task_.kind, *task_.tool).depth_mm;
      const double shift = (to.tip - from.tip).norm();
      too_deep += depth > kTooDeepShare * tolerance ? 1 : 0;
      is_forced = is_forced && shift <= tolerance + kSideShiftsPerDepth * depth;
      // Between two clean positions so near to each other the arc, which is checked whole, says enough.
      if (depth <= kMotionAimShare * tolerance && shift <= tolerance) continue;
      if (why_not_shift(from, {to.tip, from.axis}, task_.kind, *task_.tool, checker_) != nullptr) return false;
    }
    return is_forced || too_deep >= kMostOfIt * (kShiftPlaces + 1);
  }

  // The point of the new arc nearest to `from`, sought about the same instant: the distance has one least value there.
  static Pose nearest(const Motion& motion, double t, const Pose& from) {
    double low = std::max(0.0, t - kNearby), high = std::min(1.0, t + kNearby);
    for (int i = 0; i < kNarrowings; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      const bool is_first = (motion.at(a).tip - from.tip).norm() <= (motion.at(b).tip - from.tip).norm();
      (is_first ? high : low) = is_first ? b : a;
    }
    return motion.at(0.5 * (low + high));
  }

  const ArcTask& task_;
  const MotionChecker& checker_;
  CheckOptions options_;
  bool is_full_ = false;
};

}  // namespace

std::optional<PathArc> shift_arc(const ArcTask& task, const MotionChecker& checker) {
  return ArcShift(task, checker).run();
}

}  // namespace gouge
