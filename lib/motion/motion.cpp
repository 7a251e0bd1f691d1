#include "lib/motion/motion.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

// Opposite axes within this angle have no great circle a controller and we would agree on.
constexpr double kOppositeAngle_rad = 1e-6;

std::vector<MotionSegment> dogleg(const Vec3& from, const Vec3& to) {
  const Vec3 displacement = to - from;
  const double longest = displacement.cwiseAbs().maxCoeff();
  std::vector<double> breaks{0.0, 1.0};
  if (longest > 0) {
    for (int k = 0; k < 3; ++k) breaks.push_back(std::abs(displacement[k]) / longest);
  }
  std::sort(breaks.begin(), breaks.end());
  const auto at = [&](double t) {
    Vec3 tip = from;
    for (int k = 0; k < 3; ++k)
      tip[k] += std::copysign(std::min(std::abs(displacement[k]), t * longest), displacement[k]);
    return t < 1 ? tip : to;
  };
  std::vector<MotionSegment> segments;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i] < breaks[i + 1]) segments.push_back({breaks[i], breaks[i + 1], at(breaks[i]), at(breaks[i + 1])});
  }
  return segments;
}

/// An axis that is turned about a direction square to it.
Vec3 axis_turned(const Vec3& axis, const Vec3& about, double angle) {
  return std::cos(angle) * axis + std::sin(angle) * about.cross(axis);
}

/// Both the axis and the one on the great circle stay near the chord between the ends of the axis. Each is off by at
/// most an eighth of its acceleration. The turn bounds the angle between the ends.
double off_circle_rad(const MotionRates& rates) {
  const double chord = (rates.axis_acceleration_rad() + rates.turn_rad * rates.turn_rad) / 8;
  // Angle of two unit vectors a chord apart: 2 asin(c / 2) <= 1.05 c for c <= 1, and <= c pi / 2.
  return std::min(M_PI, (chord <= 1 ? 1.05 : M_PI / 2) * chord);
}

}  // namespace

Motion::Motion(const Pose& start, const Pose& end, const AxisLaw* law, const Toolpath* path, std::size_t move)
    : start_(start), end_(end), whole_{0, 1, start.tip, end.tip} {
  if (law == nullptr) {
    turn_on_great_circle();
    return;
  }
  std::shared_ptr<const AxisPath> turn = law->of_move(path, move, start, end);
  if (law->scope() == LawScope::documented || law->scope() == LawScope::circle) {
    turn_on_great_circle();
    is_defined_ = is_defined_ && turn != nullptr;
    if (turn != nullptr) end_directions_ = {turn->axes_at(0), turn->axes_at(1)};
    if (law->scope() == LawScope::documented) other_path_ = std::move(turn);
    return;
  }
  is_any_ = law->scope() == LawScope::any;
  axis_path_ = std::move(turn);
  is_defined_ = axis_path_ != nullptr;
  if (is_defined_ && axis_path_->tip_path() != nullptr) run_by_law();
}

std::optional<Motion> Motion::other() const {
  if (other_path_ == nullptr) return std::nullopt;
  Motion even = alone();
  even.axis_path_ = other_path_;
  even.end_directions_.reset();
  even.is_even_ = true;
  return even;
}

Motion Motion::alone() const {
  Motion same = *this;
  same.other_path_ = nullptr;
  same.is_any_ = false;
  return same;
}

Motion Motion::at_rest(const TurnShares& shares) const {
  Motion resting = alone();
  const AxisPath& joints = other_path_ ? *other_path_ : *axis_path_;
  const Eigen::Matrix3d axes = joints.axes_at_shares(shares).value();
  resting.axis_path_ = standing_with(axes);
  resting.end_directions_.reset();
  resting.start_.axis = resting.end_.axis = axes.col(2).normalized();
  resting.rest_ = shares;
  return resting;
}

Motion Motion::with(const std::optional<TurnShares>& shares) const {
  if (!shares) return alone();
  return other_path_ ? *other() : at_rest(*shares);
}

std::optional<TurnShares> Motion::shares_at(double t) const {
  if (rest_) return rest_;
  return is_even_ ? std::optional(TurnShares{t, t}) : std::nullopt;
}

void Motion::turn_on_great_circle() {
  const Vec3 across = start_.axis.cross(end_.axis);
  const double sine = across.norm();
  angle_ = std::atan2(sine, start_.axis.dot(end_.axis));
  if (sine > 0) rotation_axis_ = across / sine;
  // For axes that nearly agree the cross product is mostly rounding. Any perpendicular axis serves a rotation of that
  // size, but it must be perpendicular.
  rotation_axis_ -= rotation_axis_.dot(start_.axis) * start_.axis;
  if (sine <= Tolerance::kNoDirection || rotation_axis_.norm() < 0.5) {
    rotation_axis_ = start_.axis.unitOrthogonal();
    if (angle_ < 1) angle_ = 0;
  }
  rotation_axis_.normalize();
  is_defined_ = angle_ < M_PI - kOppositeAngle_rad;
}

void Motion::run_by_law() {
  tip_path_ = axis_path_->tip_path();
  MotionSegment segment = whole_;
  for (const double kink : tip_path_->kinks()) {
    segment.t1 = kink;
    segment.tip1 = tip_path_->tip_at(kink);
    segments_.push_back(segment);
    segment.t0 = kink;
    segment.tip0 = segment.tip1;
  }
  segment.t1 = 1;
  segment.tip1 = end_.tip;
  segments_.push_back(segment);
}

void Motion::run_dogleg() {
  if (tip_path_ == nullptr) segments_ = dogleg(start_.tip, end_.tip);
}

Vec3 Motion::Turn::at(double t) const {
  const double turned = sweep * t;
  return center + (r0 + dr * t) * (std::cos(turned) * e1 + std::sin(turned) * e2) + (h0 + dh * t) * axis + t * rest;
}

void Motion::run_along(const PathArc& arc) {
  is_defined_ = is_defined_ && tip_path_ == nullptr;
  if (!is_defined_) return;
  curve_ = CurveKind::arc;
  const Vec3 from = start_.tip - arc.center, to = end_.tip - arc.center;
  turn_.center = arc.center;
  turn_.axis = arc.axis;
  turn_.sweep = arc.sweep_rad;
  turn_.h0 = from.dot(arc.axis);
  turn_.dh = to.dot(arc.axis) - turn_.h0;
  const Vec3 radial = from - turn_.h0 * arc.axis;
  turn_.r0 = radial.norm();
  turn_.dr = (to - to.dot(arc.axis) * arc.axis).norm() - turn_.r0;
  turn_.e1 = turn_.r0 > 0 ? Vec3(radial / turn_.r0) : arc.axis.unitOrthogonal();
  turn_.e2 = arc.axis.cross(turn_.e1);
  turn_.rest = end_.tip - turn_.at(1);
}

void Motion::run_along(const PathSpline& spline) {
  is_defined_ = is_defined_ && tip_path_ == nullptr;
  if (!is_defined_) return;
  curve_ = CurveKind::spline;
  pieces_ = spline.pieces;
  pieces_.front().control.front() = start_.tip;
  pieces_.back().control.back() = end_.tip;
  for (const SplinePiece& piece : pieces_)
    segments_.push_back({piece.u0, piece.u1, piece.control.front(), piece.control.back()});
}

Vec3 Motion::tip_at(double t, std::uint32_t segment) const {
  const MotionSegment& displacement = segments()[segment];
  if (t >= displacement.t1) return displacement.tip1;
  if (t <= displacement.t0) return displacement.tip0;
  if (tip_path_ != nullptr) return tip_path_->tip_at(t);
  if (curve_ == CurveKind::arc) return turn_.at(t);
  if (curve_ == CurveKind::spline) return pieces_[segment].at(t);
  return displacement.tip0 +
         (t - displacement.t0) / (displacement.t1 - displacement.t0) * (displacement.tip1 - displacement.tip0);
}

double Motion::path_length_mm(double t0, double t1, std::uint32_t segment) const {
  if (tip_path_ != nullptr) return tip_path_->bounds(t0, t1).length_mm;
  const MotionSegment& displacement = segments()[segment];
  switch (curve_) {
    case CurveKind::none:
      return (displacement.tip1 - displacement.tip0).norm() * (t1 - t0) / (displacement.t1 - displacement.t0);
    case CurveKind::arc: {
      const double around = std::abs(turn_.sweep) * turn_.largest_radius();
      return (t1 - t0) * (std::sqrt(around * around + turn_.dh * turn_.dh) + std::abs(turn_.dr) + turn_.rest.norm());
    }
    case CurveKind::spline:
      break;
  }
  return (t1 - t0) * pieces_[segment].largest_speed();
}

double Motion::sag_mm(double t0, double t1, std::uint32_t segment) const {
  const double h = t1 - t0;
  if (tip_path_ != nullptr) return tip_path_->bounds(t0, t1).acceleration_mm * h * h / 8;
  switch (curve_) {
    case CurveKind::none:
      return 0;
    case CurveKind::arc: {
      const double turned = std::abs(turn_.sweep) * h;
      const double radius = turn_.largest_radius();
      return std::min(2 * radius, turned * (radius * turned + 2 * std::abs(turn_.dr) * h) / 8);
    }
    case CurveKind::spline:
      break;
  }
  return pieces_[segment].largest_second_derivative() * h * h / 8;
}

bool Motion::is_within(double limit_mm) const {
  const auto holds = [limit_mm](const Vec3& p) { return (p.array().abs() <= limit_mm).all(); };
  if (!holds(start_.tip) || !holds(end_.tip)) return false;
  if (tip_path_ != nullptr) {
    return std::ranges::all_of(segments_, [&](const MotionSegment& segment) {
      return segment.tip0.cwiseAbs().maxCoeff() + tip_path_->bounds(segment.t0, segment.t1).length_mm <= limit_mm;
    });
  }
  if (curve_ == CurveKind::arc) return holds(turn_.center) && turn_.largest_radius() <= limit_mm;
  return std::all_of(pieces_.begin(), pieces_.end(), [&](const SplinePiece& piece) {
    return std::all_of(piece.control.begin(), piece.control.end(), holds);
  });
}

double Motion::turn_rad(double t0, double t1) const {
  return axis_path_ ? (t1 - t0) * axis_path_->turn_rate_rad(t0, t1) : angle_ * (t1 - t0);
}

MotionRates Motion::rates(double t0, double t1, std::uint32_t segment) const {
  MotionRates rates;
  if (tip_path_ != nullptr) {
    const TipBounds tip = tip_path_->bounds(t0, t1);
    rates.tip_path_mm = tip.length_mm;
    rates.tip_sag_mm = tip.acceleration_mm * (t1 - t0) * (t1 - t0) / 8;
  } else {
    rates.tip_path_mm = path_length_mm(t0, t1, segment);
    rates.tip_sag_mm = sag_mm(t0, t1, segment);
  }
  rates.turn_rad = turn_rad(t0, t1);
  if (axis_path_) {
    const double h = t1 - t0;
    rates.turn_sag_rad = h * h * axis_path_->turn_acceleration_rad(t0, t1);
    rates.off_circle_rad = off_circle_rad(rates);
  }
  return rates;
}

Eigen::Matrix3d Motion::axes_at(double t) const {
  if (axis_path_) return axis_path_->axes_at(t);
  const Vec3 axis = axis_turned(start_.axis, rotation_axis_, angle_ * t);
  Eigen::Matrix3d axes;
  axes.col(0) = rotation_axis_;
  axes.col(1) = axis.cross(rotation_axis_);
  axes.col(2) = axis;
  return axes;
}

Eigen::Matrix3d Motion::turn_to(double t) const {
  if (axis_path_) return axis_path_->axes_at(t) * axis_path_->axes_at(0).transpose();
  return Eigen::AngleAxisd(angle_ * t, rotation_axis_).toRotationMatrix();
}

Pose Motion::at(double t) const {
  if (t <= 0) return start_;
  if (t >= 1) return end_;
  const std::span<const MotionSegment> ways = segments();
  const auto segment = std::lower_bound(ways.begin(), ways.end() - 1, t,
                                        [](const MotionSegment& s, double instant) { return s.t1 < instant; });
  const Vec3 axis =
      axis_path_ ? Vec3(axis_path_->axes_at(t).col(2)) : axis_turned(start_.axis, rotation_axis_, angle_ * t);
  return {tip_at(t, static_cast<std::uint32_t>(segment - ways.begin())), axis.normalized()};
}

}  // namespace gouge
