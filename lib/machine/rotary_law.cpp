#include "lib/machine/rotary_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/path/path_info.h"
#include "lib/path/toolpath.h"

namespace gouge {
namespace {

/// Both joints run evenly. The angular velocity is the sum of one about a fixed direction and one about a direction
/// that the first joint turns. So it is at most the sum of both rates, and changes by at most their product.
class EvenTurn : public AxisPath {
 public:
  EvenTurn(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to)
      : u_(machine.joints[machine.rotary[0]].direction),
        w_(machine.joints[machine.rotary[1]].direction),
        rest_(machine.rest.rotation),
        from_(from),
        by_{to[0] - from[0], to[1] - from[1]} {}

  [[nodiscard]] Eigen::Matrix3d axes_at(double t) const override {
    return (Eigen::AngleAxisd(from_[0] + t * by_[0], u_) * Eigen::AngleAxisd(from_[1] + t * by_[1], w_))
               .toRotationMatrix() *
           rest_;
  }
  [[nodiscard]] double turn_rate_rad(double /*t0*/, double /*t1*/) const override {
    return std::sqrt(by_[0] * by_[0] + by_[1] * by_[1] + 2 * std::abs(by_[0] * by_[1] * u_.dot(w_)));
  }
  [[nodiscard]] double turn_acceleration_rad(double /*t0*/, double /*t1*/) const override {
    return std::abs(by_[0] * by_[1]) * u_.cross(w_).norm();
  }
  [[nodiscard]] std::optional<Eigen::Matrix3d> axes_at_shares(const TurnShares& shares) const override {
    return (Eigen::AngleAxisd(from_[0] + shares[0] * by_[0], u_) * Eigen::AngleAxisd(from_[1] + shares[1] * by_[1], w_))
               .toRotationMatrix() *
           rest_;
  }
  // The second joint turns the axis by at most its own angle times the sine of the angle between them. Then the first
  // one turns it, at an angle to its direction that the second one has changed by no more. Proof: docs/method/machine.md.
  [[nodiscard]] TurnSpread spread(const TurnShares& low, const TurnShares& high) const override {
    const double first = 0.5 * std::abs((high[0] - low[0]) * by_[0]);
    const double second = 0.5 * std::abs((high[1] - low[1]) * by_[1]);
    const double leaning = second * w_.cross(Vec3(rest_.col(2))).norm();
    const Vec3 middle = axes_at_shares({0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])})->col(2);
    const double sine = std::min(1.0, u_.cross(middle).norm() + leaning);
    return {std::min(M_PI, leaning + first * sine), std::min(M_PI, first + second)};
  }

 private:
  Vec3 u_, w_;
  Eigen::Matrix3d rest_;
  RotaryAngles from_, by_;
};

double turn(const RotaryAngles& from, const RotaryAngles& to) {
  return std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]);
}

bool is_at(const Machine& machine, const RotaryAngles& angles, const Vec3& axis) {
  return (tool_axes(machine, angles).col(2) - axis).norm() < Tolerance::kSameDirection;
}

}  // namespace

std::optional<AngleRange> nearest_angles(const Machine& machine, const Vec3& from, const Vec3& to) {
  const RotarySolutions start = rotary_angles(machine, from), end = rotary_angles(machine, to);
  std::optional<AngleRange> best;
  for (RotaryAngles a : start.all) {
    for (RotaryAngles b : end.all) {
      if (start.is_pole) a[0] = end.is_pole ? 0 : b[0];
      if (end.is_pole) b[0] = a[0];
      for (std::size_t k = 0; k < 2; ++k) b[k] = a[k] + std::remainder(b[k] - a[k], kWholeTurn_rad);
      if (!best || turn(a, b) < turn(best->from, best->to)) best = {a, b};
    }
  }
  return best;
}

std::optional<AngleRange> angles_of_move(const Machine& machine, const JointPath* joints, std::size_t move,
                                         const Vec3& from, const Vec3& to) {
  if (joints != nullptr && move < joints->end.size() && joints->end[move]) {
    // A position alone has no angles at a start: it stands at its end.
    const RotaryAngles &end = *joints->end[move], start = joints->start[move].value_or(end);
    if (is_at(machine, start, from) && is_at(machine, end, to)) return AngleRange{start, end};
  }
  return nearest_angles(machine, from, to);
}

std::shared_ptr<const AxisPath> standing_at(const Vec3& axis) {
  Eigen::Matrix3d axes;
  axes.col(0) = axis.unitOrthogonal();
  axes.col(1) = axis.cross(axes.col(0));
  axes.col(2) = axis;
  return standing_with(axes);
}

std::string RotaryLaw::name() const {
  switch (scope_) {
    case LawScope::one:
      break;
    case LawScope::circle:
      return "great-circle";
    case LawScope::documented:
      return "documented of " + machine_.name;
    case LawScope::any:
      return "any of " + machine_.name;
  }
  return "axis of " + machine_.name;
}

std::shared_ptr<const AxisPath> RotaryLaw::between(const Pose& from, const Pose& to) const {
  return of_move(nullptr, 0, from, to);
}

std::shared_ptr<const AxisPath> RotaryLaw::of_move(const Toolpath* path, std::size_t move, const Pose& from,
                                                   const Pose& to) const {
  const JointPath* const joints = path == nullptr ? nullptr : path->joints.get();
  if (const auto angles = angles_of_move(machine_, joints, move, from.axis, to.axis))
    return std::make_shared<EvenTurn>(machine_, angles->from, angles->to);
  return from.axis == to.axis ? standing_at(from.axis) : nullptr;
}

double largest_gap_rad(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to) {
  const EvenTurn even(machine, from, to);
  const Vec3 a = even.axes_at(0).col(2), b = even.axes_at(1).col(2);
  const double angle = angle_between_rad(a, b);
  Vec3 across = b - a.dot(b) * a;
  if (across.norm() > Tolerance::kNoDirection) across.normalize();
  const auto gap = [&](double t) {
    const Vec3 on_circle = std::cos(angle * t) * a + std::sin(angle * t) * across;
    const Vec3 axis = even.axes_at(t).col(2);
    return angle_between_rad(axis, on_circle);
  };
  // Coarse samples, then golden sections about the largest: the gap has few maxima.
  constexpr int kSamples = 64, kHalvings = 40;
  int best = 0;
  for (int k = 1; k < kSamples; ++k) best = gap(1.0 * k / kSamples) > gap(1.0 * best / kSamples) ? k : best;
  double low = std::max(0.0, (best - 1.0) / kSamples), high = std::min(1.0, (best + 1.0) / kSamples);
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  for (int k = 0; k < kHalvings; ++k) {
    const double t0 = high - golden * (high - low), t1 = low + golden * (high - low);
    (gap(t0) > gap(t1) ? high : low) = gap(t0) > gap(t1) ? t1 : t0;
  }
  return gap(0.5 * (low + high));
}

}  // namespace gouge
