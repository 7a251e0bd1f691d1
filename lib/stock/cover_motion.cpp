#include "lib/stock/cover_motion.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

// The distance from a cutter that is not convex may have several minima along a motion.
constexpr int kFirstOfNearest = 24;
constexpr double kGolden = 0.6180339887498949;
// A search for the best instant ends after this many values; it has then divided the interval by ten thousand.
constexpr int kMaxValues = 20;

double largest_value(const ConvexPiece& piece, std::span<const Disc> discs, const Vec3& tip, const Vec3& axis) {
  double most = -std::numeric_limits<double>::max();
  for (const Disc& disc : discs) most = std::max(most, piece.value(disc, tip, axis));
  return most;
}

/// Returns the instant at which the axis passes nearest to a point; on a motion along the axis, the one that brings the
/// middle of the piece there.
double first_guess(const StraightCut& cut, const ConvexPiece& piece, const Vec3& point) {
  const Vec3 across = cut.by - cut.by.dot(cut.axis) * cut.axis;
  const Vec3 from = point - cut.from;
  const double square = across.squaredNorm();
  if (square > Tolerance::kNoSide * cut.by.squaredNorm()) return std::clamp(from.dot(across) / square, 0.0, 1.0);
  const double along = cut.by.dot(cut.axis);
  if (!(std::abs(along) > 0)) return 0;
  return std::clamp((from.dot(cut.axis) - 0.5 * (piece.z_lo_mm + piece.z_hi_mm)) / along, 0.0, 1.0);
}

/// Minimizes a convex function of [0, 1] whose slope is at most `steepest`, until a value is at most `wanted` or no value
/// can be. Returns whether it found one.
template <typename Function>
bool falls_to(double wanted, double guess, double steepest, const Function& value) {
  const double first = value(guess);
  if (first <= wanted) return true;
  if (first - wanted > steepest) return false;
  double a = 0, b = 1;
  double x = b - kGolden * (b - a), y = a + kGolden * (b - a);
  double at_x = value(x), at_y = value(y);
  for (int k = 0; k < kMaxValues; ++k) {
    const double least = std::min(at_x, at_y);
    if (least <= wanted) return true;
    if (least - wanted > steepest * (b - a)) return false;
    if (at_x < at_y) {
      b = y, y = x, at_y = at_x;
      x = b - kGolden * (b - a), at_x = value(x);
    } else {
      a = x, x = y, at_x = at_y;
      y = a + kGolden * (b - a), at_y = value(y);
    }
  }
  return std::min(at_x, at_y) <= wanted;
}

/// An interval of instants with the value at its middle.
struct Instants {
  double a = 0, b = 0, value = 0;
  [[nodiscard]] double middle() const { return 0.5 * (a + b); }
};

/// Seeks an instant of [t0, t1] with a value of at most `wanted`. `way(a, b)` bounds the change of the value over [a, b].
/// Halves first the interval with the lowest value in its middle; intervals whose value cannot fall enough are left out.
/// Nothing: no instant was found.
template <typename Value, typename Way>
std::optional<double> instant_below(double t0, double t1, double wanted, const Value& value, const Way& way) {
  std::vector<Instants> waiting;
  std::size_t count = 0;
  std::optional<double> found;
  const auto is_higher = [](const Instants& x, const Instants& y) { return x.value > y.value; };
  const auto add = [&](double a, double b) {
    const double middle = 0.5 * (a + b), at = value(middle);
    ++count;
    if (at <= wanted) found = middle;
    if (found || at - std::max(way(a, middle), way(middle, b)) > wanted) return;
    waiting.push_back({a, b, at});
    std::push_heap(waiting.begin(), waiting.end(), is_higher);
  };
  add(t0, t1);
  while (!found && !waiting.empty() && count < kMaxCoverInstants) {
    std::pop_heap(waiting.begin(), waiting.end(), is_higher);
    const Instants lowest = waiting.back();
    waiting.pop_back();
    if (!(lowest.middle() > lowest.a && lowest.b > lowest.middle())) continue;
    add(lowest.a, lowest.middle());
    if (!found) add(lowest.middle(), lowest.b);
  }
  return found;
}

/// Returns whether a piece is at one place during its interval.
bool rests(const SweptPiece& piece) {
  return std::equal(piece.at0.begin(), piece.at0.begin() + static_cast<std::ptrdiff_t>(piece.count), piece.at1.begin(),
                    [](const Disc& a, const Disc& b) {
                      return (a.center - b.center).isZero(0) && (a.normal - b.normal).isZero(0) &&
                             !(a.radius_mm < b.radius_mm) && !(b.radius_mm < a.radius_mm);
                    });
}

/// Seeks the instants of one segment of a motion at which a convex piece of its cutter contains a piece of space.
class SegmentCover {
 public:
  SegmentCover(const Motion& motion, std::uint32_t segment, const ConvexPiece& piece, const SweptPiece& swept)
      : motion_(motion),
        segment_(segment),
        is_turning_(motion.turn_rad() > 0),
        is_at_rest_(rests(swept)),
        axis_(motion.at(motion.segments()[segment].t0).axis),
        piece_(piece),
        swept_(swept) {}

  [[nodiscard]] bool has_one_instant(const CutWindow& window, double wanted) const {
    return find(window, wanted,
                [&](double t) {
                  const double start = at(t, swept_.start());
                  return is_at_rest_ ? start : std::max(start, at(t, swept_.end()));
                })
        .has_value();
  }

  /// The sag of the cutter's way between both instants is lost; so lower values are sought where it matters.
  [[nodiscard]] bool has_two_instants(const CutWindow& window, double wanted) const {
    double lower = wanted;
    for (int k = 0; k < kLowered; ++k) {
      const auto start = find(window, lower, [&](double t) { return at(t, swept_.start()); });
      if (!start || is_at_rest_) return start.has_value();
      const auto end = at(*start, swept_.end()) <= lower
                           ? start
                           : find(window, lower, [&](double t) { return at(t, swept_.end()); });
      if (!end) return false;
      const double sag = motion_.sag_mm(std::min(*start, *end), std::max(*start, *end), segment_);
      if (std::max(at(*start, swept_.start()), at(*end, swept_.end())) <= wanted - sag) return true;
      lower = wanted - sag;
    }
    return false;
  }

 private:
  static constexpr int kLowered = 2;

  [[nodiscard]] double at(double t, std::span<const Disc> discs) const {
    return largest_value(piece_, discs, motion_.tip_at(t, segment_), is_turning_ ? motion_.at(t).axis : axis_);
  }

  template <typename Value>
  [[nodiscard]] std::optional<double> find(const CutWindow& window, double wanted, const Value& value) const {
    return instant_below(window.from, window.until, wanted, value, [&](double a, double b) {
      const double length = motion_.path_length_mm(a, b, segment_);
      if (!is_turning_) return length;
      const double turn = motion_.turn_rad(a, b);
      const Vec3 tip = motion_.tip_at(a, segment_);
      double far = 0;
      for (const std::span<const Disc> discs : {swept_.start(), swept_.end()})
        for (const Disc& disc : discs) far = std::max(far, (disc.center - tip).norm() + disc.radius_mm);
      return length + turn * (far + length);
    });
  }

  const Motion& motion_;
  std::uint32_t segment_;
  bool is_turning_, is_at_rest_;
  Vec3 axis_;  // at the start
  const ConvexPiece& piece_;
  const SweptPiece& swept_;
};

/// Returns the lowest value of a function that is found on [t0, t1]: at even instants, then about the best of them.
template <typename Function>
double lowest_value(double t0, double t1, const Function& value) {
  double best = t0, least = std::numeric_limits<double>::max();
  const auto take = [&](double t) {
    const double v = value(t);
    if (v < least) least = v, best = t;
  };
  constexpr int kRounds = 12;
  for (int k = 0; k <= kFirstOfNearest; ++k) take(t0 + (t1 - t0) * k / kFirstOfNearest);
  double step = (t1 - t0) / kFirstOfNearest;
  for (int k = 0; k < kRounds; ++k) {
    step *= 0.5;
    const double about = best;
    take(std::max(t0, about - step));
    take(std::min(t1, about + step));
  }
  return least;
}

}  // namespace

bool is_covered_by(const StraightCut& cut, const std::vector<ConvexPiece>& pieces, const SweptPiece& swept,
                   const CoverMargin& margin) {
  const double length = cut.by.norm();
  const bool is_at_rest = rests(swept);
  for (const ConvexPiece& piece : pieces) {
    const double wanted = margin.largest_value(piece);
    const auto is_swept = [&](const Disc& disc) {
      return falls_to(wanted, first_guess(cut, piece, disc.center), length,
                      [&](double u) { return piece.value(disc, cut.from + u * cut.by, cut.axis); });
    };
    const std::span<const Disc> start = swept.start(), end = swept.end();
    const bool has_start = std::all_of(start.begin(), start.end(), is_swept);
    if (has_start && (is_at_rest || std::all_of(end.begin(), end.end(), is_swept))) return true;
  }
  return false;
}

bool is_covered_by(const Motion& motion, const CutWindow& window, const std::vector<ConvexPiece>& pieces,
                   const SweptPiece& swept, const CoverMargin& margin) {
  const bool is_turning = motion.turn_rad() > 0;
  for (std::uint32_t s = 0; s < motion.segments().size(); ++s) {
    const MotionSegment& segment = motion.segments()[s];
    if (segment.t0 > window.until || segment.t1 < window.from) continue;
    const double from = std::max(segment.t0, window.from);
    const CutWindow part{from, motion.is_alone() ? from : std::min(segment.t1, window.until)};
    for (const ConvexPiece& piece : pieces) {
      const SegmentCover cover(motion, s, piece, swept);
      const double wanted = margin.largest_value(piece);
      if (is_turning ? cover.has_one_instant(part, wanted) : cover.has_two_instants(part, wanted)) return true;
    }
  }
  return false;
}

double nearest_distance_mm(const Motion& motion, const MotionSpan& span, const CompiledTool& cutter,
                           const Vec3& point) {
  return lowest_value(static_cast<double>(span.t0), static_cast<double>(span.t1), [&](double t) {
    return signed_distance_mm(cutter, Pose{motion.tip_at(t, span.segment), motion.at(t).axis}, point);
  });
}

}  // namespace gouge
