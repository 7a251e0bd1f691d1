#include "lib/path/nearest_feed.h"

#include <limits>
#include <utility>

#include "lib/base/tolerance.h"

namespace gouge {

FeedsInBlocks::FeedsInBlocks(std::vector<MotionChord> feeds) : feeds_(std::move(feeds)) {
  for (std::size_t level = 0; level < kSizes.size(); ++level) {
    boxes_[level].resize((feeds_.size() + kSizes[level] - 1) / kSizes[level]);
    for (std::size_t i = 0; i < feeds_.size(); ++i)
      boxes_[level][i / kSizes[level]].extend(feeds_[i].from.tip).extend(feeds_[i].to.tip);
  }
}

std::size_t FeedsInBlocks::count_far(const Pose& pose, std::size_t begin, double far_mm) const {
  if (begin % kSizes.back() != 0) return 0;
  constexpr double kRounding_mm = 1e-6;
  for (std::size_t level = 0; level < kSizes.size(); ++level) {
    if (begin % kSizes[level] != 0) continue;
    if (boxes_[level][begin / kSizes[level]].exteriorDistance(pose.tip) > far_mm + kRounding_mm) return kSizes[level];
  }
  return 0;
}

PoseDistance NearestFeed::find(const Pose& pose) {
  best_ = {};
  nearest_mm_ = std::numeric_limits<double>::infinity();
  const std::size_t count = feeds_.all().size(), ahead = std::min(count, last_ + kAhead);
  const std::size_t begin = begin_ = last_;
  const bool is_found = look_at(pose, begin, ahead, Tolerance::kSamePoint_mm) || best_.sum(height_mm_) < kAlike_mm ||
                        look_at(pose, ahead, count, kAlike_mm);
  if (!is_found) look_at(pose, 0, begin, kAlike_mm);
  return {nearest_mm_, best_.axis_rad};
}

bool NearestFeed::look_at(const Pose& pose, std::size_t begin, std::size_t end, double enough_mm) {
  const std::vector<MotionChord>& feeds = feeds_.all();
  for (std::size_t i = begin; i < end; ++i) {
    const double far_mm = nearest_mm_ + kAlike_mm;
    if (const std::size_t far = feeds_.count_far(pose, i, far_mm); far > 0) {
      i += far - 1;
      continue;
    }
    if (tip_bound_mm(pose, feeds[i]) > far_mm) continue;
    const PoseDistance found = distance_from(pose, feeds[i]);
    if (found.tip_mm > far_mm) continue;
    nearest_mm_ = std::min(nearest_mm_, found.tip_mm);
    const bool is_best_near = best_.tip_mm <= nearest_mm_ + kAlike_mm;
    if (is_best_near && !(found.sum(height_mm_) < best_.sum(height_mm_))) continue;
    best_ = found;
    last_ = i;
    if (best_.sum(height_mm_) < enough_mm) return true;
  }
  return false;
}

}  // namespace gouge
