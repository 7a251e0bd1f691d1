#include "lib/correct/shift_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/contact/contacts.h"
#include "lib/correct/correct_pose.h"

namespace gouge {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kHeightShare = 0.2;
constexpr double kTooDeepShare = 0.5;
constexpr double kMaxOfIt = 0.9;
constexpr double kSweepChange_rad = 0.2;
constexpr double kMinRadius_mm = 1e-3;
constexpr int kShiftPlaces = 16;
constexpr double kNearby = 0.2;  // share of the motion
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
  // Returns the arc about the point nearest to `center` that is equally far from both ends.
  [[nodiscard]] std::optional<PathArc> about(Vec3 center) const {
    const Vec3& axis = task_.arc.axis;
    const Vec3 &s = task_.new_start.tip, &e = task_.new_end.tip;
    const double rise = (e - s).dot(axis) - (task_.end.tip - task_.start.tip).dot(axis);
    if (std::abs(rise) > kHeightShare * checker_.options().tolerance_mm) return std::nullopt;
    PathArc arc = task_.arc;
    if (!is_full_) {
      const Vec3 chord = across(e - s, axis);
      const double length = chord.norm();
      if (!(length > kMinRadius_mm)) return std::nullopt;
      const Vec3 middle = 0.5 * (s + e);
      center -= (center - middle).dot(chord) / (length * length) * chord;
    }
    const Vec3 from = across(s - center, axis), to = across(e - center, axis);
    if (!(from.norm() > kMinRadius_mm)) return std::nullopt;
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
      // Between two clean positions so near to each other, the arc itself suffices, because it is checked completely.
      if (depth <= kMotionAimShare * tolerance && shift <= tolerance) continue;
      if (why_not_shift(from, {to.tip, from.axis}, task_.kind, *task_.tool, checker_) != nullptr) return false;
    }
    return is_forced || too_deep >= kMaxOfIt * (kShiftPlaces + 1);
  }

  // Returns the point of the new arc nearest to `from`. It is searched around the same instant: there the distance has
  // only one minimum.
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

namespace {

constexpr int kSplitPlaces = 32;
constexpr int kSplitHalvings = 10;
constexpr double kMinSection_mm = 0.05;            // a shorter arc is not worth a statement, and digits blur it
constexpr double kShares[] = {0, 1.0 / 16, 0.25};  // shares of a stretch that are given up for the path to the
                                                   // corrected part

class ArcSplit {
 public:
  ArcSplit(const ArcTask& task, const std::vector<Pose>& chords, const MotionChecker& checker)
      : task_(task),
        chords_(chords),
        checker_(checker),
        options_(checker.options()),
        whole_(options_.law.along(task.start, task.end, task.arc)) {
    options_.tolerance_mm *= kMotionAimShare;
    options_.near_miss_mm = 0;
    keeps_start_ = (task.start.tip - task.new_start.tip).norm() <= Tolerance::kSamePoint_mm;
    keeps_end_ = (task.end.tip - task.new_end.tip).norm() <= Tolerance::kSamePoint_mm;
  }

  std::optional<std::vector<ArcPiece>> run() {
    for (const Pose* pose : {&task_.end, &task_.new_start, &task_.new_end}) {
      if ((pose->axis - task_.start.axis).norm() > Tolerance::kExactDirection) return std::nullopt;
    }
    find_segments();
    if (sections_.empty()) return std::nullopt;
    for (const double share : kShares) {
      pieces_.clear();
      if (build(share) && pieces_.size() <= chords_.size() + 1) return std::move(pieces_);
    }
    return std::nullopt;
  }

 private:
  struct Section {
    double from = 0, to = 1;  // first and last instant on the arc
  };

  [[nodiscard]] bool is_clean(const Motion& motion) const {
    return checker_.is_clean(motion, task_.kind, *task_.tool, options_);
  }
  [[nodiscard]] PathArc part(double from, double to) const {
    return {task_.arc.center, task_.arc.axis, task_.arc.sweep_rad * (to - from)};
  }
  [[nodiscard]] bool is_clean(double from, double to) const {
    return is_clean(options_.law.along(whole_.at(from), whole_.at(to), part(from, to)));
  }
  [[nodiscard]] double length_mm(double from, double to) const {
    return arc_length_mm(part(from, to), whole_.at(from).tip, whole_.at(to).tip);
  }

  // Returns the last instant between `clean` and `gouging` for which `is_clean_to` holds.
  template <class IsClean>
  static double last_clean(double clean, double gouging, const IsClean& is_clean_to) {
    for (int i = 0; i < kSplitHalvings; ++i) {
      const double middle = 0.5 * (clean + gouging);
      (is_clean_to(middle) ? clean : gouging) = middle;
    }
    return clean;
  }

  void find_segments() {
    std::vector<bool> is_free(kSplitPlaces + 1);
    for (int i = 0; i <= kSplitPlaces; ++i) {
      const bool is_kept = (i > 0 || keeps_start_) && (i < kSplitPlaces || keeps_end_);
      is_free[static_cast<std::size_t>(i)] =
          is_kept && is_clean(options_.law.at(whole_.at(static_cast<double>(i) / kSplitPlaces)));
    }
    for (std::size_t first = 0, last = 0; first < is_free.size(); first = last + 1) {
      for (last = first; last < is_free.size() && is_free[last];) ++last;
      if (last > first + 1) add_section(first, last - 1);
    }
  }

  void add_section(std::size_t first, std::size_t last) {
    double from = static_cast<double>(first) / kSplitPlaces, to = static_cast<double>(last) / kSplitPlaces;
    if (!is_clean(from, to)) return;
    const double step = 1.0 / kSplitPlaces;
    if (last < kSplitPlaces) to = last_clean(to, to + step, [&](double t) { return is_clean(from, t); });
    if (first > 0) from = last_clean(from, from - step, [&](double t) { return is_clean(t, to); });
    if (length_mm(from, to) >= kMinSection_mm) sections_.push_back({from, to});
  }

  bool build(double share) {
    Pose at = task_.new_start;
    double t = 0;
    for (Section section : sections_) {
      const double less = share * (section.to - section.from);
      if (section.from > 0) section.from += less;
      if (section.to < 1) section.to -= less;
      if (section.from > 0 && !lead(at, t, whole_.at(section.from), section.from)) return false;
      at = section.to < 1 ? whole_.at(section.to) : task_.new_end;
      t = section.to;
      pieces_.push_back({at, part(section.from, section.to)});
    }
    return t >= 1 || lead(at, t, task_.new_end, 1);
  }

  // Leads from `from`, which represents the instant `t0`, to `to`: by one arc or by the chords.
  bool lead(const Pose& from, double t0, const Pose& to, double t1) {
    const ArcTask task{part(t0, t1), whole_.at(t0), whole_.at(t1), from, to, task_.kind, task_.tool};
    if (const std::optional<PathArc> arc = shift_arc(task, checker_)) {
      pieces_.push_back({to, arc});
      return true;
    }
    std::vector<Pose> stops;
    for (const Pose& chord : chords_) {
      const double t = instant_of(chord);
      if (t > t0 && t < t1) stops.push_back(chord);
    }
    stops.push_back(to);
    Pose at = from;
    for (std::size_t next = 0; next < stops.size(); ++next) {
      std::size_t last = stops.size();
      while (last > next && !may_skip(at, stops, next, last - 1)) --last;
      if (last == next) return false;
      at = stops[last - 1];
      next = last - 1;
      pieces_.push_back({at, std::nullopt});
    }
    return true;
  }

  // Returns whether the path may go straight to stop `last` and skip the stops from `next` on. It must stay as near to
  // them as the chords to the arc.
  [[nodiscard]] bool may_skip(const Pose& at, const std::vector<Pose>& stops, std::size_t next,
                              std::size_t last) const {
    const Vec3 displacement = stops[last].tip - at.tip;
    for (std::size_t k = next; k < last; ++k) {
      const Vec3 to = stops[k].tip - at.tip;
      const double u = std::clamp(to.dot(displacement) / displacement.squaredNorm(), 0.0, 1.0);
      if ((to - u * displacement).norm() > checker_.options().tolerance_mm) return false;
    }
    return is_clean(options_.law.straight(at, stops[last]));
  }

  // Returns the position on the arc, from the angle about its centre.
  [[nodiscard]] double instant_of(const Pose& pose) const {
    const Vec3& axis = task_.arc.axis;
    const auto across = [&](const Vec3& displacement) { return Vec3(displacement - displacement.dot(axis) * axis); };
    const Vec3 from = across(task_.start.tip - task_.arc.center), to = across(pose.tip - task_.arc.center);
    const double sign = task_.arc.sweep_rad < 0 ? -1 : 1;
    double angle = sign * std::atan2(axis.dot(from.cross(to)), from.dot(to));
    if (angle < 0) angle += 2 * std::numbers::pi;
    return angle / std::abs(task_.arc.sweep_rad);
  }

  const ArcTask& task_;
  const std::vector<Pose>& chords_;
  const MotionChecker& checker_;
  CheckOptions options_;
  Motion whole_;
  bool keeps_start_ = false, keeps_end_ = false;
  std::vector<Section> sections_;
  std::vector<ArcPiece> pieces_;
};

}  // namespace

std::optional<std::vector<ArcPiece>> split_arc(const ArcTask& task, const std::vector<Pose>& chords,
                                               const MotionChecker& checker) {
  return ArcSplit(task, chords, checker).run();
}

}  // namespace gouge
