#include "postproc/image/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"

namespace gouge {

View make_view(const Vec3& toward, const Vec3& up_hint, int width, int height) {
  View view;
  view.toward = toward.normalized();
  Vec3 right = up_hint.cross(view.toward);
  // Looking along the hint leaves "up" open; y, then x, are what people expect then.
  if (right.norm() < Tolerance::kNoSide) right = Vec3::UnitY().cross(view.toward);
  if (right.norm() < Tolerance::kNoSide) right = Vec3::UnitX().cross(view.toward);
  view.right = right.normalized();
  view.up = view.toward.cross(view.right);
  view.width = width;
  view.height = height;
  return view;
}

void fit_view(View& view, std::span<const std::span<const Vec3>> points, double margin) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Vec3 low(kFar, kFar, kFar);
  Vec3 high = -low;
  for (const std::span<const Vec3> some : points) {
    for (const Vec3& p : some) {
      const Vec3 q(p.dot(view.right), p.dot(view.up), p.dot(view.toward));
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
  }
  if (!(low.x() <= high.x())) low = high = Vec3::Zero();
  const Vec3 middle = 0.5 * (low + high);
  view.centre = view.right * middle.x() + view.up * middle.y() + view.toward * middle.z();
  const double inner = 1 - 2 * margin;
  view.mm_per_pixel = std::max({(high.x() - low.x()) / (inner * view.width),
                                (high.y() - low.y()) / (inner * view.height), Tolerance::kRounding});
}

}  // namespace gouge
