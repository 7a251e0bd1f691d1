#pragma once

#include <cstddef>
#include <optional>

#include "lib/path/nearest_feed.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Finds the tip of straight motions that is farthest from the feeds of another path, also between their ends. The feeds
/// must outlive it.
/// Proof    Along a straight motion, the distance from one feed is convex, so its values at both ends bound it. The distance
///          from all feeds changes by at most the way of the tip. A motion is divided until one of both bounds is enough.
class FarthestTip {
 public:
  /// No tip is farther than the larger of `within_mm` and 1.01 * distance_mm(). Requires `within_mm` > 0.
  FarthestTip(const FeedsInBlocks& feeds, double within_mm) : nearest_(feeds, 0), within_mm_(within_mm) {}

  /// Adds a motion. Returns whether one of its tips is farther than all before.
  /// Cost     Two searches if the ends are near the same feed; else about as many as there are feeds along it.
  bool add(const Vec3& from, const Vec3& to);

  [[nodiscard]] double distance_mm() const { return distance_mm_; }         ///< of the farthest tip; 0: there is none
  [[nodiscard]] std::size_t nearest_move() const { return nearest_move_; }  ///< the move of the feed nearest to it

 private:
  struct Place {
    Vec3 tip;
    double distance_mm = 0;
    const MotionChord* nearest = nullptr;
  };

  Place look_at(const Vec3& tip);
  [[nodiscard]] static double bound_mm(const Place& from, const Place& to);

  NearestFeed nearest_;
  double within_mm_;
  std::optional<Place> last_;  // the end of the last motion, where the next one often begins
  double distance_mm_ = 0;
  std::size_t nearest_move_ = kNone;
};

}  // namespace gouge
