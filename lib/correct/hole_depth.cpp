#include "lib/correct/hole_depth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/surface/surface.h"

namespace gouge {
namespace {

constexpr double kBeside = 1.25;  // of the radius, where material is sought
constexpr int kDirections = 8, kHeights = 64;
constexpr double kTopExact_mm = 1e-3;

bool is_in_part(const Vec3& point, const PreparedScene& scene) {
  return std::ranges::any_of(scene.workpiece().surfaces,
                             [&](const Surface& surface) { return surface.is_solid() && surface.winds_around(point); });
}

/// The height at which the material that begins beside the drill ends; 0: there is none.
double top_mm(const Vec3& foot, const Vec3& axis, double most_mm, const PreparedScene& scene) {
  const auto is_in = [&](double height) { return is_in_part(foot + height * axis, scene); };
  double in = 0, out = most_mm;
  bool is_found = false;
  for (int k = 0; k <= kHeights; ++k) {
    const double height = std::max(most_mm * (k - 0.5) / kHeights, kTopExact_mm);
    if (is_in(height)) {
      is_found = true;
      in = height;
    } else if (is_found) {
      out = height;
      break;
    }
  }
  if (!is_found) return 0;
  while (out - in > kTopExact_mm) {
    const double middle = 0.5 * (in + out);
    (is_in(middle) ? in : out) = middle;
  }
  return in;
}

}  // namespace

double depth_below_surface_mm(const Pose& pose, double radius_mm, double most_mm, const PreparedScene& scene) {
  if (!(most_mm > 0) || !scene.is_within_reach) return 0;
  const Vec3 across = pose.axis.unitOrthogonal(), other = pose.axis.cross(across);
  double least = most_mm;
  for (int k = 0; k < kDirections && least > 0; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
    const Vec3 away = kBeside * radius_mm * (std::cos(angle) * across + std::sin(angle) * other);
    least = std::min(least, top_mm(pose.tip + away, pose.axis, most_mm, scene));
  }
  return least;
}

}  // namespace gouge
