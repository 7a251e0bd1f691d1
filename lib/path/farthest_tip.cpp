#include "lib/path/farthest_tip.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/geom/triangle.h"

namespace gouge {
namespace {

constexpr double kEnough = 1.01;  // times the largest distance. A smaller factor divides motions more often

double tip_distance_mm(const Vec3& tip, const MotionChord& feed) {
  return distance_to_segment(tip, feed.from.tip, feed.to.tip);
}

}  // namespace

FarthestTip::Place FarthestTip::look_at(const Vec3& tip) {
  const double distance_mm = nearest_.find({tip, Vec3::UnitZ()}).tip_mm;
  if (distance_mm > distance_mm_) {
    distance_mm_ = distance_mm;
    nearest_move_ = nearest_.move();
  }
  return {tip, distance_mm, &nearest_.feed()};
}

double FarthestTip::bound_mm(const Place& from, const Place& to) {
  const double by_way = 0.5 * (from.distance_mm + to.distance_mm + (to.tip - from.tip).norm());
  const double by_first = std::max(from.distance_mm, tip_distance_mm(to.tip, *from.nearest));
  const double by_last = std::max(tip_distance_mm(from.tip, *to.nearest), to.distance_mm);
  return std::min({by_way, by_first, by_last});
}

bool FarthestTip::add(const Vec3& from, const Vec3& to) {
  const double before_mm = distance_mm_;
  const Place first = last_ && last_->tip == from ? *last_ : look_at(from);
  last_ = look_at(to);
  std::vector<std::pair<Place, Place>> pieces = {{first, *last_}};
  while (!pieces.empty()) {
    const auto [begin, end] = pieces.back();
    pieces.pop_back();
    if (bound_mm(begin, end) <= std::max(within_mm_, kEnough * distance_mm_)) continue;
    const Place middle = look_at(0.5 * (begin.tip + end.tip));
    pieces.emplace_back(middle, end);
    pieces.emplace_back(begin, middle);
  }
  return distance_mm_ > before_mm;
}

}  // namespace gouge
