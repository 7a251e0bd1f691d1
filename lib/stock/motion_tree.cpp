#include "lib/stock/motion_tree.h"

#include <limits>

#include "lib/base/tolerance.h"
#include "lib/path/path_info.h"

namespace gouge {

namespace {

constexpr std::uint32_t kSpansOfCell = 4;
constexpr double kWidestTurn_rad = 0.1;
// The sag of a span, as a share of its longest path; so an arc is divided into about an eighth of a circle.
constexpr double kSagShare = 0.015;
// Any two directions differ by at most pi; two points of a sphere are nearer than the arc between them.
constexpr double kWidestCone_rad = 2;

// Rounds a bound to a float, away from the interval.
float below(double value) { return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::max()); }
float above(double value) { return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::max()); }

Vec3 vec(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

void set_axis(MotionSpan& span, const Vec3& axis) {
  for (std::size_t k = 0; k < 3; ++k) span.axis[k] = static_cast<float>(axis[static_cast<int>(k)]);
}

MotionSpan span_of(const Motion& motion, const Departure& departure, std::uint32_t move, std::uint32_t segment,
                   double t0, double t1) {
  MotionSpan span;
  span.move = move;
  span.segment = segment;
  span.t0 = static_cast<float>(t0);
  span.t1 = static_cast<float>(t1);
  const MotionRates rates = motion.rates(t0, t1, segment);
  const Vec3 a = motion.tip_at(t0, segment), b = motion.tip_at(t1, segment);
  const double off = rates.tip_sag_mm + departure.tip_mm;
  for (int k = 0; k < 3; ++k) {
    span.low[static_cast<std::size_t>(k)] = below(std::min(a[k], b[k]) - off);
    span.high[static_cast<std::size_t>(k)] = above(std::max(a[k], b[k]) + off);
  }
  set_axis(span, motion.at(0.5 * (t0 + t1)).axis);
  // Half of the turn from the middle, and the rounding of the direction.
  const double turn =
      rates.turn_rad > 0 ? std::max(motion.turn_rad(t0, 0.5 * (t0 + t1)), motion.turn_rad(0.5 * (t0 + t1), t1)) : 0;
  span.cone_rad = above(turn + departure.axis_rad + Tolerance::kSingleRounding);
  return span;
}

}  // namespace

void append_spans(const Motion& motion, const Departure& departure, std::uint32_t move, double longest_mm,
                  std::vector<MotionSpan>& spans) {
  const std::span<const MotionSegment> segments = motion.segments();
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    const double t0 = segments[s].t0, t1 = motion.is_alone() ? t0 : segments[s].t1;
    const double length = motion.path_length_mm(t0, t1, s), turn = motion.turn_rad(t0, t1);
    // The sag of a part falls with the square of their number.
    const double bent = std::sqrt(motion.is_alone() ? 0.0 : motion.sag_mm(t0, t1, s) / (kSagShare * longest_mm));
    const double wanted = std::ceil(std::max({length / longest_mm, turn / kWidestTurn_rad, bent}));
    const int parts = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMaxSpans)));
    // Instants are rounded to floats before they are used, so that the spans have no gaps.
    const auto instant = [&](int k) {
      return k == parts ? t1 : static_cast<double>(static_cast<float>(t0 + (t1 - t0) * k / parts));
    };
    for (int k = 0; k < parts; ++k)
      spans.push_back(span_of(motion, departure, move, s, k == 0 ? t0 : instant(k), instant(k + 1)));
  }
}

MotionTree::MotionTree(std::vector<MotionSpan> spans) : spans_(std::move(spans)) {
  if (!spans_.empty()) build(0, static_cast<std::uint32_t>(spans_.size()));
}

void MotionTree::build(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(cells_.size());
  cells_.push_back({around(first, last), 0, first, last});
  if (last - first <= kSpansOfCell) return;
  const MotionSpan& bounds = cells_[index].bounds;
  std::size_t widest = 0;
  const auto width = [&](std::size_t k) { return bounds.high[k] - bounds.low[k]; };
  for (std::size_t k = 1; k < 3; ++k)
    if (width(k) > width(widest)) widest = k;
  const std::uint32_t middle = first + (last - first) / 2;
  const auto comes_first = [widest](const MotionSpan& a, const MotionSpan& b) {
    const float x = a.low[widest] + a.high[widest], y = b.low[widest] + b.high[widest];
    if (x < y || y < x) return x < y;
    return a.move != b.move ? a.move < b.move : a.t0 < b.t0;
  };
  std::nth_element(spans_.begin() + first, spans_.begin() + middle, spans_.begin() + last, comes_first);
  build(first, middle);
  const auto second = static_cast<std::uint32_t>(cells_.size());
  cells_[index].second = second;
  build(middle, last);
}

MotionSpan MotionTree::around(std::uint32_t first, std::uint32_t last) const {
  MotionSpan all = spans_[first];
  Vec3 axis = Vec3::Zero();
  for (std::uint32_t s = first; s < last; ++s) {
    const MotionSpan& span = spans_[s];
    all.move = std::min(all.move, span.move);
    for (std::size_t k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], span.low[k]);
      all.high[k] = std::max(all.high[k], span.high[k]);
    }
    axis += vec(span.axis);
  }
  if (axis.norm() < Tolerance::kNoSide) axis = vec(spans_[first].axis);
  set_axis(all, axis.normalized());
  double cone = 0;
  for (std::uint32_t s = first; s < last; ++s)
    cone =
        std::max(cone, angle_between_rad(vec(all.axis), vec(spans_[s].axis)) + static_cast<double>(spans_[s].cone_rad));
  all.cone_rad = above(cone + Tolerance::kSingleRounding);
  return all;
}

// Let the tip be in the box, the axis in the cone, and the cylinder moved out by grow_mm contain the piece.
// (1) The axis moves a point of the piece by at most cone * length in the tool's frame.
// (2) Across the axis a disc of any direction reaches its radius r on both sides of its centre. So the centre is at most
//     sqrt(R^2 - r^2) from the axis.
// (3) Along the axis both middle +- half are within the heights.
bool MotionTree::may_contain(const MotionSpan& span, const SoughtPiece& piece, const ToolCylinder& body) {
  const double grown = body.radius_mm + piece.grow_mm, square = grown * grown - piece.disc_mm * piece.disc_mm;
  if (grown < 0 || square < 0) return false;
  const double radius = std::sqrt(square);
  const Vec3 low = vec(span.low), high = vec(span.high), axis = vec(span.axis);
  const Vec3 half = 0.5 * (high - low), from = piece.middle - 0.5 * (low + high);
  const double cone = std::min(static_cast<double>(span.cone_rad), kWidestCone_rad);
  const double reach = std::max(body.z_hi_mm, -body.z_lo_mm) + body.radius_mm + std::max(0.0, piece.grow_mm);
  const double slack = cone * reach + Tolerance::kSingleSum * (reach + from.norm());
  const double z = from.dot(axis), swing = half.cwiseProduct(axis.cwiseAbs()).sum() + slack + piece.grow_mm;
  const double along = std::abs(piece.half.dot(axis)) - cone * piece.half.norm();
  const double inset = std::max(0.0, along);
  if (z < body.z_lo_mm - swing + inset || z > body.z_hi_mm + swing - inset) return false;
  const double widest = radius + half.norm() + slack;
  if (from.squaredNorm() - z * z > widest * widest) return false;
  for (int k = 0; k < 3; ++k) {
    const double sideways = radius * std::sqrt(std::max(0.0, 1 - axis[k] * axis[k])) + slack + piece.grow_mm;
    const double a = axis[k] * body.z_lo_mm, b = axis[k] * body.z_hi_mm;
    if (from[k] < std::min(a, b) - sideways - half[k] || from[k] > std::max(a, b) + sideways + half[k]) return false;
  }
  return true;
}

}  // namespace gouge
