#include "lib/check/sweep_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

// Relative error of a length in single precision, including everything that the kernel computes from it.
constexpr double kSingle = 2e-6;

// A path is divided until the chord is this close and no step is longer or turns more, or until the maximum number of
// steps.
constexpr double kSmallSag_mm = 0.002;
constexpr double kSmallTurn_rad = 0.1;
constexpr double kShortPath_mm = 4;
constexpr int kMaxSteps = 64;

/// Returns a bound of the angle between two unit vectors with this chord: 2 asin(c / 2) <= c + c^3 / 20 for c <= 1, and
/// <= c pi / 2.
double angle_over(double chord) { return chord <= 1 ? chord + chord * chord * chord / 20 : 0.5 * M_PI * chord; }

float rounded_up(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::max()); }

std::array<float, 3> single(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Vec3 kept(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

/// Positions of the ends of the steps on the line from the first pose to the last: -1/2 to 1/2.
class Line {
 public:
  explicit Line(std::span<const SweepInterval> steps)
      : count_(static_cast<double>(steps.size())),
        middle_(0.5 * (steps.front().from.tip + steps.back().to.tip)),
        displacement_(steps.back().to.tip - steps.front().from.tip) {
    double spread2 = 0;
    for (const SweepInterval& step : steps) spread2 = std::max(spread2, (step.to.tip - middle_).squaredNorm());
    is_by_path_ = displacement_.squaredNorm() > Tolerance::kNoSide * spread2 && steps.size() > 1;
    if (is_by_path_) per_length2_ = 1 / displacement_.squaredNorm();
  }
  [[nodiscard]] const Vec3& displacement() const { return displacement_; }
  [[nodiscard]] const Vec3& middle() const { return middle_; }
  /// Returns the position of a pose. `index` is 0 for the start of the first step, and k for the end of step k - 1.
  [[nodiscard]] double at(const Pose& pose, double index) const {
    if (!is_by_path_) return index / count_ - 0.5;
    return std::clamp((pose.tip - middle_).dot(displacement_) * per_length2_, -0.5, 0.5);
  }

 private:
  double count_;
  Vec3 middle_, displacement_;
  double per_length2_ = 0;
  bool is_by_path_ = false;
};

template <typename Visit>
void each_pose(std::span<const SweepInterval> steps, const Visit& visit) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool goes_on =
        i > 0 && steps[i].from.tip == steps[i - 1].to.tip && steps[i].from.axis == steps[i - 1].to.axis;
    if (!goes_on) visit(steps[i].from, static_cast<double>(i));
    visit(steps[i].to, static_cast<double>(i + 1));
  }
}

}  // namespace

void append_steps(const Motion& motion, std::uint32_t move, std::vector<SweepInterval>& steps) {
  for (std::uint32_t s = 0; s < motion.segments().size(); ++s) {
    const MotionSegment& segment = motion.segments()[s];
    const double length = motion.is_alone() ? 0 : segment.t1 - segment.t0;
    const auto is_long = [&](const MotionRates& first) {
      return first.turn_rad > kSmallTurn_rad || first.tip_path_mm > kShortPath_mm || first.tip_sag_mm > kSmallSag_mm;
    };
    int parts = 1;
    MotionRates first = motion.rates(segment.t0, segment.t0 + length, s);
    while (parts < kMaxSteps && is_long(first)) {
      parts *= 2;
      first = motion.rates(segment.t0, segment.t0 + length / parts, s);
    }
    Pose from = motion.at(segment.t0);
    for (int k = 0; k < parts; ++k) {
      SweepInterval step;
      step.move = move;
      step.segment = s;
      step.t0 = segment.t0 + length * k / parts;
      step.t1 = k + 1 == parts ? segment.t0 + length : segment.t0 + length * (k + 1) / parts;
      step.from = from;
      step.to = motion.is_alone() ? from : motion.at(step.t1);
      step.rates = k == 0 ? first : motion.rates(step.t0, step.t1, s);
      steps.push_back(step);
      from = step.to;
    }
  }
}

std::array<SweepInterval, 2> halved(const Motion& motion, const SweepInterval& step) {
  std::array<SweepInterval, 2> parts = halves(step);
  parts[0].to = parts[1].from = motion.at(step.middle());
  for (SweepInterval& part : parts) part.rates = motion.rates(part.t0, part.t1, part.segment);
  return parts;
}

SweepFrame sweep_frame(std::span<const SweepInterval> steps, const Vec3& origin, double rounding_mm) {
  SweepFrame frame;
  const Line line(steps);
  const Vec3 sum = steps.front().from.axis + steps.back().to.axis;
  frame.axis = single(sum.norm() > 0.1 ? Vec3(sum.normalized()) : steps.front().from.axis);
  const Vec3 axis = kept(frame.axis).normalized();
  const Vec3 turn = axis.cross(steps.back().to.axis - steps.front().from.axis);

  // The tip of the frame moves to the middle of the remaining deviations from the line, which makes them smaller.
  Vec3 middle = line.middle();
  if (steps.size() > 1) {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    each_pose(steps, [&](const Pose& pose, double index) {
      const Vec3 beside = pose.tip - middle - line.at(pose, index) * line.displacement();
      low = low.cwiseMin(beside);
      high = high.cwiseMax(beside);
    });
    middle += 0.5 * (low + high);
  }
  frame.tip = single(middle - origin);
  const Vec3 tip = kept(frame.tip);

  double beside2 = 0, far2 = 0, twisted2 = 0, chord2 = 0;
  each_pose(steps, [&](const Pose& pose, double index) {
    const double s = line.at(pose, index);
    const Vec3 displacement = pose.tip - origin - tip;
    beside2 = std::max(beside2, (displacement - s * line.displacement()).squaredNorm());
    far2 = std::max(far2, displacement.squaredNorm());
    twisted2 = std::max(twisted2, (axis.cross(pose.axis) - s * turn).squaredNorm());
    chord2 = std::max(chord2, (axis - pose.axis).squaredNorm());
  });
  double beside = std::sqrt(beside2), far = std::sqrt(far2), twisted = std::sqrt(twisted2);
  double sag = 0, bend = 0, off_circle = 0;
  for (const SweepInterval& step : steps) {
    sag = std::max(sag, step.rates.tip_sag_mm);
    bend = std::max(bend, step.rates.axis_acceleration_rad() / 8);
    off_circle = std::max(off_circle, step.rates.off_circle_rad);
  }
  const double widest = angle_over(std::sqrt(chord2)) + off_circle;
  beside += sag;
  far += sag;
  twisted += bend + widest * widest * widest / 6;

  frame.displacement = single(line.displacement());
  frame.turn = single(turn);
  frame.displacement_mm = rounded_up(line.displacement().norm());
  frame.half_turn = rounded_up(0.5 * turn.norm());
  const double scale = kSingle * (line.displacement().norm() + far) + rounding_mm;
  frame.beside_mm = rounded_up(beside + scale);
  frame.rest_mm = rounded_up(beside + widest * far * (1 + 0.5 * widest) + scale);
  frame.rest_per_mm = rounded_up(twisted + 0.5 * widest * widest + kSingle * (1 + turn.norm()));
  return frame;
}

}  // namespace gouge
