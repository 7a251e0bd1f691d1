#include "lib/path/chords.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr double kMaxChords = 10000;

std::size_t count_for(double chords) {
  return static_cast<std::size_t>(std::clamp(std::ceil(chords), 1.0, kMaxChords));
}

void append_arc(const PathArc& arc, const Pose& start, const Pose& end, double error_mm, std::vector<Pose>& poses) {
  const Vec3 from = start.tip - arc.center, to = end.tip - arc.center;
  const double z0 = from.dot(arc.axis), z1 = to.dot(arc.axis);
  const Vec3 radial = from - z0 * arc.axis;
  const double r0 = radial.norm(), r1 = (to - z1 * arc.axis).norm();
  const Vec3 x = radial / r0, y = arc.axis.cross(x);
  const double radius = std::max(r0, r1);
  const double step = 2 * std::acos(std::max(0.0, 1 - std::min(error_mm, radius) / radius));
  const std::size_t count = count_for(std::abs(arc.sweep_rad) / step);
  for (std::size_t i = 1; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    const double angle = t * arc.sweep_rad;
    const Vec3 tip = arc.center + (z0 + t * (z1 - z0)) * arc.axis +
                     (r0 + t * (r1 - r0)) * (std::cos(angle) * x + std::sin(angle) * y);
    poses.push_back({tip, axis_between(start.axis, end.axis, t)});
  }
}

void append_spline(const PathSpline& spline, const Pose& start, const Pose& end, double error_mm,
                   std::vector<Pose>& poses) {
  for (const SplinePiece& piece : spline.pieces) {
    const double width = piece.u1 - piece.u0;
    const std::size_t count = count_for(width * std::sqrt(piece.largest_second_derivative() / (8 * error_mm)));
    for (std::size_t i = 1; i <= count; ++i) {
      const double u = piece.u0 + width * static_cast<double>(i) / static_cast<double>(count);
      poses.push_back({piece.at(u), axis_between(start.axis, end.axis, u)});
    }
  }
  if (!poses.empty()) poses.pop_back();
}

}  // namespace

Vec3 axis_between(const Vec3& from, const Vec3& to, double t) {
  const double sine = from.cross(to).norm();
  const double angle = std::atan2(sine, from.dot(to));
  if (!(sine > Tolerance::kNoDirection)) return t < 1 ? from : to;
  return (from * (std::sin((1 - t) * angle) / sine) + to * (std::sin(t * angle) / sine)).normalized();
}

std::vector<Pose> chords_of(const Toolpath& path, std::size_t index, double error_mm) {
  const Move& move = path.moves[index];
  const Pose& start = path.start_of(index);
  std::vector<Pose> poses;
  if (move.curve_kind == CurveKind::arc) append_arc(path.arcs[move.curve], start, move.end, error_mm, poses);
  if (move.curve_kind == CurveKind::spline) append_spline(path.splines[move.curve], start, move.end, error_mm, poses);
  poses.push_back(move.end);
  return poses;
}

}  // namespace gouge
