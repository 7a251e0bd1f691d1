#include "lib/path/axis_tilt.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/path/chords.h"
#include "lib/path/path_info.h"

namespace gouge {

namespace {

constexpr double kCurveError_mm = 0.05;
constexpr double kMinMargin_mm = 1, kMaxMargin_mm = 10, kMarginOfLength = 0.1;
constexpr double kCosOfCorner = 0.9;  // cosine of about 26 degrees: at a smaller angle the feed bends, at a larger one
                                      // it turns a corner
constexpr double kPlunge =
    0.3;  // sine of some 17 degrees: a tip that moves nearer to the axis plunges, so its feed has no side

/// A place of the curve, which a straight line reaches.
struct Place {
  double length_mm = 0;
  Vec3 tip = Vec3::Zero(), programmed = Vec3::UnitZ(), corrected = Vec3::UnitZ();
};

Place between(const Place& a, const Place& b, double length_mm) {
  const double t = (length_mm - a.length_mm) / (b.length_mm - a.length_mm);
  return {length_mm, a.tip + t * (b.tip - a.tip), axis_between(a.programmed, b.programmed, t),
          axis_between(a.corrected, b.corrected, t)};
}

class TiltCurve {
 public:
  TiltCurve(const Toolpath& after, const std::vector<Vec3>& programmed) : after_(after), programmed_(programmed) {}

  TiltedRun run(std::size_t first, std::size_t last) {
    TiltedRun run;
    run.first = first;
    run.last = last;
    double length_mm = 0;
    for (std::size_t k = first; k < last; ++k) length_mm += after_.moves[k].has_start ? move_length_mm(after_, k) : 0;
    const double margin_mm = std::clamp(kMarginOfLength * length_mm, kMinMargin_mm, kMaxMargin_mm);
    const std::size_t from = margin_before(first, margin_mm), to = margin_behind(last, margin_mm);
    if (after_.moves[from].has_start) append_start_of(from);
    for (std::size_t k = from; k < to; ++k) {
      if (k == first) run.begin_mm = end_mm();
      append(k);
      if (k + 1 == last) run.end_mm = end_mm();
    }
    cut(run, margin_mm);
    set_reference();
    run.curve = angles();
    return run;
  }

 private:
  [[nodiscard]] bool is_margin(std::size_t k) const {
    return after_.moves[k].has_start && after_.moves[k].kind != MoveKind::rapid;
  }
  [[nodiscard]] std::size_t margin_before(std::size_t first, double margin_mm) const {
    if (!after_.moves[first].has_start) return first;
    for (double left_mm = margin_mm; left_mm > 0 && first > 0 && is_margin(first - 1); --first)
      left_mm -= move_length_mm(after_, first - 1);
    return first;
  }
  [[nodiscard]] std::size_t margin_behind(std::size_t last, double margin_mm) const {
    for (double left_mm = margin_mm; left_mm > 0 && last < after_.moves.size() && is_margin(last); ++last)
      left_mm -= move_length_mm(after_, last);
    return last;
  }

  [[nodiscard]] double end_mm() const { return places_.empty() ? 0 : places_.back().length_mm; }

  void append_start_of(std::size_t k) {
    const Pose& start = after_.start_of(k);
    places_.push_back({0, start.tip, programmed_[k - 1], start.axis});
  }

  void append(std::size_t k) {
    const Move& move = after_.moves[k];
    if (!move.has_start) {
      places_.push_back({end_mm(), move.end.tip, programmed_[k], move.end.axis});
      return;
    }
    const std::vector<Pose> poses = chords_of(after_, k, kCurveError_mm);
    const Vec3 from = programmed_[k - 1];
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double t = static_cast<double>(i + 1) / static_cast<double>(poses.size());
      const double length_mm = end_mm() + (poses[i].tip - places_.back().tip).norm();
      places_.push_back({length_mm, poses[i].tip, axis_between(from, programmed_[k], t), poses[i].axis});
    }
  }

  // Cuts the margins. They extend to the ends of their moves, which may be long.
  void cut(TiltedRun& run, double margin_mm) {
    const double begin_mm = std::max(0.0, run.begin_mm - margin_mm);
    const double end_mm = std::min(this->end_mm(), run.end_mm + margin_mm);
    std::vector<Place> kept;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& here = places_[i];
      const bool is_last = i + 1 == places_.size();
      if (here.length_mm >= begin_mm && here.length_mm <= end_mm) kept.push_back(here);
      if (is_last) break;
      const Place& next = places_[i + 1];
      if (here.length_mm < begin_mm && next.length_mm > begin_mm) kept.push_back(between(here, next, begin_mm));
      if (here.length_mm < end_mm && next.length_mm > end_mm) kept.push_back(between(here, next, end_mm));
    }
    for (Place& place : kept) place.length_mm -= begin_mm;
    run.begin_mm -= begin_mm;
    run.end_mm -= begin_mm;
    places_ = std::move(kept);
  }

  void set_reference() {
    Vec3 sum = Tolerance::kNoSide * places_.front().programmed;
    for (std::size_t i = 1; i < places_.size(); ++i) {
      sum +=
          0.5 * (places_[i].length_mm - places_[i - 1].length_mm) * (places_[i].programmed + places_[i - 1].programmed);
    }
    up_ = sum.norm() > Tolerance::kSameDirection ? sum.normalized() : places_.front().programmed;
  }

  /// Returns the direction of the tip from place i - 1 to i, in the view along the reference. Returns zero if the tip
  /// does not move or plunges.
  [[nodiscard]] Vec3 forward_to(std::size_t i) const {
    const Vec3 along = places_[i].tip - places_[i - 1].tip;
    const Vec3 across = along - along.dot(up_) * up_;
    return across.norm() > kPlunge * along.norm() && across.norm() > Tolerance::kSameDirection
               ? Vec3(across.normalized())
               : Vec3(Vec3::Zero());
  }

  [[nodiscard]] TiltPlace angles_at(const Place& place, const Vec3& forward) const {
    const Vec3 left = up_.cross(forward);
    const auto angle = [&](const Vec3& axis, const Vec3& towards) {
      return std::atan2(axis.dot(towards), axis.dot(up_));
    };
    return {place.length_mm, angle(place.programmed, forward), angle(place.programmed, left),
            angle(place.corrected, forward), angle(place.corrected, left)};
  }

  [[nodiscard]] std::vector<TiltPlace> angles() const {
    std::vector<Vec3> forward(places_.size() + 1, Vec3::Zero());  // [i] is the direction to place i
    for (std::size_t i = 1; i < places_.size(); ++i) forward[i] = forward_to(i);
    for (std::size_t i = 1; i < forward.size(); ++i) {
      if (forward[i].isZero()) forward[i] = forward[i - 1];
    }
    for (std::size_t i = forward.size() - 1; i-- > 0;) {
      if (forward[i].isZero()) forward[i] = forward[i + 1];
    }
    std::vector<TiltPlace> curve;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Vec3 in = forward[i].isZero() ? Vec3(up_.unitOrthogonal()) : forward[i];
      const Vec3 out = forward[i + 1].isZero() ? in : forward[i + 1];
      if (in.dot(out) > kCosOfCorner) {
        curve.push_back(angles_at(places_[i], (in + out).normalized()));
      } else {
        curve.push_back(angles_at(places_[i], in));
        curve.push_back(angles_at(places_[i], out));
      }
    }
    return curve;
  }

  const Toolpath& after_;
  const std::vector<Vec3>& programmed_;
  std::vector<Place> places_;
  Vec3 up_ = Vec3::UnitZ();
};

// Returns the run of the moves [first, last) of a corrected path with its curve. The curve covers these moves, and up
// to a tenth of their length (1 to 10 mm) of the feed moves on each side. `programmed` has the programmed axis at the
// end of every move. The result has no tilt_rad.
TiltedRun draw_tilt_curve(const Toolpath& after, const std::vector<Vec3>& programmed, std::size_t first,
                          std::size_t last) {
  return TiltCurve(after, programmed).run(first, last);
}

constexpr double kGap_mm = 2;

/// Moves [first, last) and the length of their path.
struct MoveSpan {
  std::size_t first = 0, last = 0;
  double length_mm = 0;
};

class TiltedSpans {
 public:
  TiltedSpans(const Toolpath& after, const std::vector<double>& tilts) : after_(after), tilts_(tilts) {}

  [[nodiscard]] std::vector<MoveSpan> find() {
    for (std::size_t k = 0; k < tilts_.size(); ++k) {
      const bool has_start = after_.moves[k].has_start;
      const bool is_tilted =
          tilts_[k] > AxisTilts::kLeast_rad || (has_start && k > 0 && tilts_[k - 1] > AxisTilts::kLeast_rad);
      const double length_mm = has_start ? move_length_mm(after_, k) : 0;
      if (!has_start) is_open_ = false;
      if (is_tilted)
        extend(k, length_mm);
      else
        gap_mm_ += length_mm;
    }
    return std::move(spans_);
  }

 private:
  void extend(std::size_t k, double length_mm) {
    if (!is_open_ || gap_mm_ > kGap_mm) {
      spans_.push_back({k, k, 0});
    } else {
      spans_.back().length_mm += gap_mm_;
    }
    spans_.back().last = k + 1;
    spans_.back().length_mm += length_mm;
    gap_mm_ = 0;
    is_open_ = true;
  }

  const Toolpath& after_;
  const std::vector<double>& tilts_;
  std::vector<MoveSpan> spans_;
  double gap_mm_ = 0;
  bool is_open_ = false;
};

std::vector<MoveSpan> longest(std::vector<MoveSpan> spans, std::size_t most) {
  if (spans.size() <= most) return spans;
  std::vector<std::size_t> order(spans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spans[a].length_mm > spans[b].length_mm; });
  order.resize(most);
  std::sort(order.begin(), order.end());
  std::vector<MoveSpan> kept;
  kept.reserve(most);
  for (const std::size_t i : order) kept.push_back(spans[i]);
  return kept;
}

}  // namespace

AxisTilts find_axis_tilts(const Toolpath& before, const Toolpath& after, const std::vector<std::size_t>& origins,
                          std::size_t max_runs) {
  AxisTilts found;
  if (origins.size() != after.moves.size()) return found;
  const std::vector<Vec3> programmed = programmed_axes(before, after, origins);
  std::vector<double> tilts(programmed.size());
  for (std::size_t k = 0; k < programmed.size(); ++k) {
    tilts[k] = angle_between_rad(programmed[k], after.moves[k].end.axis);
    if (!(tilts[k] > AxisTilts::kLeast_rad)) continue;
    ++found.positions;
    found.tilt_rad.take(tilts[k], k);
  }
  const std::vector<MoveSpan> spans = TiltedSpans(after, tilts).find();
  for (const MoveSpan& span : longest(spans, max_runs)) {
    TiltedRun run = draw_tilt_curve(after, programmed, span.first, span.last);
    for (std::size_t k = span.first; k < span.last; ++k) run.tilt_rad.take(tilts[k], k);
    found.runs.push_back(std::move(run));
  }
  found.runs_left_out = spans.size() - found.runs.size();
  return found;
}

namespace {

constexpr double kAxisError_mm = 0.01;
constexpr double kTimesNearest = 2;

/// One straight piece of a programmed motion. Its axis turns evenly on the great circle.
struct Stretch {
  const Pose& from;
  const Pose& to;

  /// Returns the position of the nearest point on the line, as a share of the piece that may be outside of [0, 1], and
  /// its squared distance.
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

  /// Returns the axis nearest to the position's axis, among those of places within `reach_mm` of the position. Requires
  /// that there is such a place.
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
  double min_rad = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
    const Stretch stretch{motion[i], motion[i + 1]};
    if (stretch.distance(pose.tip) > reach_mm) continue;
    const Vec3 axis = stretch.nearest_axis(pose, reach_mm);
    const double angle = angle_between_rad(axis, pose.axis);
    if (!(angle < min_rad)) continue;
    min_rad = angle;
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
