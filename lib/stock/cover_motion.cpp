#include "lib/stock/cover_motion.h"

#include <algorithm>
#include <limits>
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

/// Finds a low value of a function on [t0, t1]: at `first` + 1 even instants, then about the best of them.
template <typename Function>
double best_instant(double t0, double t1, double wanted, const Function& value, double& at_best, int first = 4) {
  double best = t0;
  at_best = std::numeric_limits<double>::max();
  const auto take = [&](double t) {
    const double v = value(t);
    if (v < at_best) at_best = v, best = t;
  };
  constexpr int kRounds = 12;
  for (int k = 0; k <= first && at_best > wanted; ++k) take(t0 + (t1 - t0) * k / first);
  double step = (t1 - t0) / first;
  for (int k = 0; k < kRounds && at_best > wanted; ++k) {
    step *= 0.5;
    const double about = best;
    take(std::max(t0, about - step));
    take(std::min(t1, about + step));
  }
  return best;
}

/// Returns whether a piece is at one place during its interval.
bool rests(const SweptPiece& piece) {
  return std::equal(piece.at0.begin(), piece.at0.begin() + static_cast<std::ptrdiff_t>(piece.count), piece.at1.begin(),
                    [](const Disc& a, const Disc& b) {
                      return (a.center - b.center).isZero(0) && (a.normal - b.normal).isZero(0) &&
                             !(a.radius_mm < b.radius_mm) && !(b.radius_mm < a.radius_mm);
                    });
}

bool turns(const Motion& motion) { return motion.turn_rad() > 0; }

}  // namespace

bool is_covered_by(const StraightCut& cut, const std::vector<ConvexPiece>& pieces, const SweptPiece& swept,
                   const CoverMargin& margin) {
  const double length = cut.by.norm();
  for (const ConvexPiece& piece : pieces) {
    const double wanted = margin.largest_value(piece);
    const auto is_swept = [&](const Disc& disc) {
      return falls_to(wanted, first_guess(cut, piece, disc.center), length,
                      [&](double u) { return piece.value(disc, cut.from + u * cut.by, cut.axis); });
    };
    const std::span<const Disc> start = swept.start(), end = swept.end();
    if (std::all_of(start.begin(), start.end(), is_swept) && std::all_of(end.begin(), end.end(), is_swept)) return true;
  }
  return false;
}

bool is_covered_by(const Motion& motion, double until, const std::vector<ConvexPiece>& pieces, const SweptPiece& swept,
                   const CoverMargin& margin) {
  const bool is_turning = turns(motion), is_at_rest = rests(swept);
  for (std::uint32_t s = 0; s < motion.segments().size(); ++s) {
    const MotionSegment& segment = motion.segments()[s];
    if (segment.t0 > until) break;
    const double t0 = segment.t0, t1 = motion.is_alone() ? t0 : std::min(segment.t1, until);
    for (const ConvexPiece& piece : pieces) {
      const double wanted = margin.largest_value(piece);
      const auto value = [&](std::span<const Disc> discs) {
        return [&piece, &motion, discs, s](double t) {
          return largest_value(piece, discs, motion.tip_at(t, s), motion.at(t).axis);
        };
      };
      const auto at_start = value(swept.start()), at_end = value(swept.end());
      double least = 0;
      if (is_turning) {
        best_instant(
            t0, t1, wanted,
            [&](double t) {
              const double start = at_start(t);
              return is_at_rest ? start : std::max(start, at_end(t));
            },
            least);
        if (least <= wanted) return true;
        continue;
      }
      const double u0 = best_instant(t0, t1, wanted, at_start, least);
      if (least > wanted) continue;
      double least_at_end = at_end(u0), u1 = u0;
      if (least_at_end > wanted) u1 = best_instant(t0, t1, wanted, at_end, least_at_end);
      const double sag = motion.sag_mm(std::min(u0, u1), std::max(u0, u1), s);
      if (std::max(least, least_at_end) <= wanted - sag) return true;
    }
  }
  return false;
}

double nearest_distance_mm(const Motion& motion, const MotionSpan& span, const CompiledTool& cutter,
                           const Vec3& point) {
  double least = 0;
  best_instant(
      static_cast<double>(span.t0), static_cast<double>(span.t1), -std::numeric_limits<double>::max(),
      [&](double t) {
        return signed_distance_mm(cutter, Pose{motion.tip_at(t, span.segment), motion.at(t).axis}, point);
      },
      least, kFirstOfNearest);
  return least;
}

}  // namespace gouge
