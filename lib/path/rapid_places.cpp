#include "lib/path/rapid_places.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr std::size_t kMaxAtPlace = 100;  // rapids to one place that are looked at, such as those to a tool change

}  // namespace

RapidPlaces::RapidPlaces(const Toolpath& path, double within_mm, double height_mm)
    : rapids_(chords_of_rapids(path)), ends_(within_mm), within_mm_(within_mm), height_mm_(height_mm) {
  for (std::size_t i = 0; i < rapids_.size(); ++i) ends_.add(rapids_[i].to.tip, i);
}

bool RapidPlaces::passes(const MotionChord& rapid, const Pose& pose) const {
  return tip_bound_mm(pose, rapid) <= within_mm_ && distance_from(pose, rapid).is_within(within_mm_, height_mm_);
}

std::size_t RapidPlaces::ending_at(const Pose& end, const Pose& passed) const {
  for (const std::size_t i : ends_.find(end.tip, kMaxAtPlace)) {
    const MotionChord& rapid = rapids_[i];
    if (passes({rapid.to, rapid.to, rapid.move}, end) && passes(rapid, passed)) return rapid.move;
  }
  return kNone;
}

std::size_t RapidPlaces::passing(const Pose& one, const Pose& two) const {
  const auto found =
      std::ranges::find_if(rapids_, [&](const MotionChord& rapid) { return passes(rapid, one) && passes(rapid, two); });
  return found == rapids_.end() ? kNone : found->move;
}

}  // namespace gouge
