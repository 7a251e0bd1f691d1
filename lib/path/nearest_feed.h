#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lib/path/motion_chords.h"

namespace gouge {

/// Feeds of a path, with boxes about blocks of them, so that a search leaves out far blocks.
class FeedsInBlocks {
 public:
  explicit FeedsInBlocks(std::vector<MotionChord> feeds);

  [[nodiscard]] const std::vector<MotionChord>& all() const { return feeds_; }
  /// Returns the number of feeds from `begin` on whose box is farther than `far_mm` from a tip: those of a large block, of
  /// a small one, or none.
  [[nodiscard]] std::size_t count_far(const Pose& pose, std::size_t begin, double far_mm) const;

 private:
  static constexpr std::array<std::size_t, 2> kSizes = {4096, 64};  // feeds of a block

  std::vector<MotionChord> feeds_;
  std::array<std::vector<Box3>, 2> boxes_;  // of each size
};

/// Finds the feed that is nearest to a pose, for poses that follow the feeds. The feeds must outlive it.
class NearestFeed {
 public:
  /// A motion this near among those that follow the last one ends the search; one at the same point ends it at once.
  static constexpr double kAlike_mm = 1e-3;

  NearestFeed(const FeedsInBlocks& feeds, double height_mm) : feeds_(feeds), height_mm_(height_mm) {}

  /// Returns the distance of the tip from the nearest feed, and the smallest angle at a feed as near, which move() becomes.
  PoseDistance find(const Pose& pose);
  [[nodiscard]] std::size_t move() const { return feed().move; }
  [[nodiscard]] const MotionChord& feed() const { return feeds_.all()[last_]; }
  /// Returns whether a motion that is as near as the nearest one fulfils a condition. Where a path passes a place more
  /// than once, several motions do. It looks at the motions that find() looks at first.
  template <class Condition>
  [[nodiscard]] bool has_alike(const Pose& pose, Condition fulfils) const {
    const std::vector<MotionChord>& feeds = feeds_.all();
    const std::size_t end = std::min(feeds.size(), begin_ + kAhead);
    const double near_mm = std::max(kAlike_mm, best_.sum(height_mm_));
    for (std::size_t i = begin_; i < end; ++i) {
      if (tip_bound_mm(pose, feeds[i]) > near_mm || !fulfils(feeds[i].move)) continue;
      if (distance_from(pose, feeds[i]).sum(height_mm_) <= near_mm) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kAhead = 200;  // motions after the last one in which the next is looked for first

  /// Looks for a nearer feed until one is nearer than `enough_mm`. Returns whether it found one.
  bool look_at(const Pose& pose, std::size_t begin, std::size_t end, double enough_mm);

  const FeedsInBlocks& feeds_;
  double height_mm_;
  PoseDistance best_;      // as near as nearest_mm_ within kAlike_mm
  double nearest_mm_ = 0;  // distance of the nearest tip
  std::size_t last_ = 0, begin_ = 0;
};

}  // namespace gouge
