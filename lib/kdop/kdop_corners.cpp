#include "lib/kdop/kdop_corners.h"

#include <algorithm>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

using Polygon = std::vector<Vec3>;

/// Returns the part of `face` with normal . x <= offset + slack.
Polygon clipped(const Polygon& face, const Vec3& normal, double offset, double slack) {
  Polygon kept;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3& a = face[i];
    const Vec3& b = face[(i + 1) % face.size()];
    const double out_a = normal.dot(a) - offset, out_b = normal.dot(b) - offset;
    if (out_a <= slack) kept.push_back(a);
    if ((out_a > slack) != (out_b > slack)) kept.push_back(a + (out_a / (out_a - out_b)) * (b - a));
  }
  return kept;
}

double size_of(std::span<const Interval> intervals) {
  double size = 0;
  for (const Interval& i : intervals) size = std::max({size, i.high - i.low, std::abs(i.low), std::abs(i.high)});
  return size;
}

class Corners {
 public:
  explicit Corners(double size) : same_(Tolerance::kRounding * size) {}

  void add(const Vec3& corner) {
    for (const Vec3& known : all_) {
      if ((known - corner).cwiseAbs().maxCoeff() <= same_) return;
    }
    all_.push_back(corner);
  }
  [[nodiscard]] std::vector<Vec3> take() { return std::move(all_); }

 private:
  double same_;
  std::vector<Vec3> all_;
};

}  // namespace

std::vector<Interval> intervals_of(const DirectionSet& directions, std::span<const Vec3> points) {
  std::vector<Interval> all(directions.axes.size());
  for (std::size_t i = 0; i < all.size() && !points.empty(); ++i) {
    all[i].low = all[i].high = directions.axes[i].dot(points[0]);
    for (const Vec3& p : points) {
      const double at = directions.axes[i].dot(p);
      all[i].low = std::min(all[i].low, at);
      all[i].high = std::max(all[i].high, at);
    }
  }
  return all;
}

std::vector<Vec3> kdop_corners(const DirectionSet& directions, std::span<const Interval> intervals) {
  const double size = size_of(intervals);
  const double reach = 16 * size + 1, slack = Tolerance::kFewRoundings * size;
  Corners corners(size);
  for (std::size_t i = 0; i < directions.axes.size(); ++i) {
    for (const double sign : {1.0, -1.0}) {
      const Vec3 normal = sign * directions.axes[i];
      const double offset = sign > 0 ? intervals[i].high : -intervals[i].low;
      const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u), mid = offset * normal;
      Polygon face = {mid + reach * (u + v), mid + reach * (v - u), mid - reach * (u + v), mid + reach * (u - v)};
      for (std::size_t j = 0; j < directions.axes.size() && !face.empty(); ++j) {
        if (j == i) continue;
        face = clipped(face, directions.axes[j], intervals[j].high, slack);
        face = clipped(face, -directions.axes[j], -intervals[j].low, slack);
      }
      for (const Vec3& corner : face) corners.add(corner);
    }
  }
  return corners.take();
}

}  // namespace gouge
