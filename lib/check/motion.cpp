#include "lib/check/motion.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

// Opposite axes within this angle have no great circle a controller and we would agree on.
constexpr double kOppositeAngle_rad = 1e-6;

std::vector<TipStretch> dogleg(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double longest = way.cwiseAbs().maxCoeff();
  std::vector<double> breaks{0.0, 1.0};
  if (longest > 0) {
    for (int k = 0; k < 3; ++k) breaks.push_back(std::abs(way[k]) / longest);
  }
  std::sort(breaks.begin(), breaks.end());
  const auto at = [&](double t) {
    Vec3 tip = from;
    for (int k = 0; k < 3; ++k) tip[k] += std::copysign(std::min(std::abs(way[k]), t * longest), way[k]);
    return t < 1 ? tip : to;
  };
  std::vector<TipStretch> stretches;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i] < breaks[i + 1])
      stretches.push_back({breaks[i], breaks[i + 1], at(breaks[i]), at(breaks[i + 1])});
  }
  return stretches;
}

}  // namespace

Motion::Motion(const Pose& start, const Pose& end, bool is_dogleg) : start_(start), end_(end) {
  const Vec3 across = start.axis.cross(end.axis);
  const double sine = across.norm();
  angle_ = std::atan2(sine, start.axis.dot(end.axis));
  if (sine > 0) rotation_axis_ = across / sine;
  // For axes that all but agree the cross product is mostly rounding; any perpendicular axis serves a
  // rotation of that size, but it must be perpendicular.
  rotation_axis_ -= rotation_axis_.dot(start.axis) * start.axis;
  if (sine <= 1e-12 || rotation_axis_.norm() < 0.5) {
    rotation_axis_ = start.axis.unitOrthogonal();
    if (angle_ < 1) angle_ = 0;
  }
  rotation_axis_.normalize();
  is_defined_ = angle_ < M_PI - kOppositeAngle_rad;
  if (is_dogleg) {
    stretches_ = dogleg(start.tip, end.tip);
  } else {
    stretches_ = {{0, 1, start.tip, end.tip}};
  }
}

Motion::Motion(const Pose& alone) : Motion(alone, alone) {
  is_alone_ = true;
}

Pose Motion::at(double t) const {
  if (t <= 0) return start_;
  if (t >= 1) return end_;
  const auto stretch =
      std::find_if(stretches_.begin(), stretches_.end() - 1, [t](const TipStretch& s) { return t <= s.t1; });
  const double s = (t - stretch->t0) / (stretch->t1 - stretch->t0);
  const double turned = angle_ * t;
  return {
      stretch->tip0 + s * (stretch->tip1 - stretch->tip0),
      (std::cos(turned) * start_.axis + std::sin(turned) * rotation_axis_.cross(start_.axis)).normalized()};
}

}  // namespace gouge
