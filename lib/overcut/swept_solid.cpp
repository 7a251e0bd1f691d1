#include "lib/overcut/swept_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/check/motion_interval.h"

namespace gouge {
namespace {

// A tool that runs along the point keeps its distance for long: no number of instants would decide that.
constexpr int kMostInstants = 300;

/// A time interval with the distances at its ends.
struct Interval : MotionInterval {
  double d0 = 0, d1 = 0;
};

}  // namespace

/// Lipschitz in the point's position, so halving the time brackets the smallest distance: between two instants
/// it is not below the mean of both less half of the distance the point runs in tool coordinates.
SweptSolid::Nearest SweptSolid::nearest(const Vec3& point, double accuracy_mm, double enough_mm) const {
  Nearest best{distance_at(point, 0), 0, 0};
  const auto offer = [&](double t) {
    const double distance = distance_at(point, t);
    if (distance < best.distance_mm) best = {distance, t, 0};
    return distance;
  };
  best.lower_mm = best.distance_mm;
  if (motion_.is_alone()) return best;
  double lower = std::numeric_limits<double>::infinity();
  int instants = 0;
  std::vector<Interval> open;
  for (std::uint32_t s = 0; s < motion_.segments().size(); ++s) {
    const MotionInterval whole = whole_segment(motion_, s);
    open.push_back({whole, offer(whole.t0), offer(whole.t1)});
  }
  while (!open.empty()) {
    const Interval interval = open.back();
    open.pop_back();
    const double path_length = motion_.path_length_mm(interval.t0, interval.t1, interval.segment);
    const double turn = turn_rad() * (interval.t1 - interval.t0);
    const double run =
        path_length + turn * ((point - motion_.tip_at(interval.t0, interval.segment)).norm() + path_length);
    const double least = 0.5 * (interval.d0 + interval.d1 - run);
    const bool is_pruned = least >= best.distance_mm - accuracy_mm || least > enough_mm;
    if (is_pruned || ++instants > kMostInstants || interval.t1 - interval.t0 < 1e-9) {
      lower = std::min(lower, least);
      continue;
    }
    std::array<Interval, 2> parts = halves(interval);
    parts[0].d1 = parts[1].d0 = offer(interval.middle());
    for (const Interval& part : parts) open.push_back(part);
  }
  best.lower_mm = std::min(lower, best.distance_mm);
  return best;
}

Box3 SweptSolid::box() const {
  const double reach = reach_mm();
  Box3 box;
  for (std::uint32_t s = 0; s < motion_.segments().size(); ++s) {
    const MotionSegment& segment = motion_.segments()[s];
    const double wide = reach + motion_.path_length_mm(segment.t0, segment.t1, s);
    box.extend(Vec3(motion_.tip_at(segment.t0, s) - Vec3::Constant(wide)));
    box.extend(Vec3(motion_.tip_at(segment.t0, s) + Vec3::Constant(wide)));
  }
  box.extend(Vec3(motion_.at(0).tip - Vec3::Constant(reach)));
  box.extend(Vec3(motion_.at(0).tip + Vec3::Constant(reach)));
  return box;
}

}  // namespace gouge
