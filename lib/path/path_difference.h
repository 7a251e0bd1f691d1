#pragma once

#include <cstddef>
#include <optional>

#include "lib/path/toolpath.h"

namespace gouge {

/// Distances of the positions of one path from the motions of another.
struct PathDifference {
  std::size_t positions = 0;   ///< feed positions that were compared
  double tip_mm = 0;           ///< largest distance of a tip from the nearest motion
  bool is_tip_inside = false;  ///< it is on the way to the position, not at it
  double axis_rad = 0;         ///< largest of the angles between the axes at the nearest motions
  /// The position of the largest value, and the nearest motion; kNone: there is no position.
  std::size_t tip_move = kNone, tip_other = kNone, axis_move = kNone, axis_other = kNone;
  /// Positions at which the motions of both paths have feed rates in the same unit, and they differ by more than
  /// kSameFeed. Where the other path passes a place more than once, one motion with the same feed rate is enough.
  std::size_t other_feeds = 0;
  std::size_t feed_move = kNone, feed_other = kNone;  ///< the first of them, and the nearest motion
  /// Positions at which the feed rates cannot be compared: one of both is not known, or their units differ.
  std::size_t unknown_feeds = 0;
  std::size_t unknown_move = kNone, unknown_other = kNone;  ///< the first of them, and the nearest motion
  /// Feeds that are rapids in the other path, and those of them that leave along the tool axis.
  std::size_t rapids = 0, retracts = 0;
  std::size_t rapid_move = kNone, rapid_other = kNone;  ///< the first that is no retract, else the first; and the rapid

  static constexpr double kSameFeed = 0.001;  ///< share of a feed rate, for the rounding of programs
};

/// Moves of a path that a comparison leaves out.
struct MovesLeftOut {
  std::size_t feeds = 0;      ///< that are compared
  std::size_t unchecked = 0;  ///< of any kind
  std::size_t rapids = 0;     ///< that are checked
  std::size_t first_unchecked = kNone, first_unchecked_feed = kNone, first_rapid = kNone;
};

[[nodiscard]] MovesLeftOut count_left_out(const Toolpath& path);

/// Measures each checked feed of `path` against the feeds of `other`, along their arcs and splines.
///
/// Tips     They are measured along the whole feed: none is farther than the larger of `within_mm` and 1.01 * tip_mm. Between
///          two positions the tip runs straight, whatever the law of the joints.
/// Axes     They are measured at the end, and at three positions of an arc or a spline, at the motion whose tip is nearest.
///          Of motions as near within 0.001 mm, that with the smallest sum of distance and angle counts. In this sum 1 rad
///          is `height_mm`. Of equal ones, the next after the one before counts.
/// Rapids   A feed is a rapid in `other` in two cases, where distances up to `within_mm` count as none. (1) No feed passes its
///          end. A rapid ends there, or passes its middle and end. Its distance is then that from the rapid. (2) A rapid
///          passes its middle and ends at its end, and no feed passes the middle. Such a feed is measured at its end alone.
/// Returns  None: a path has no feed that is checked.
/// Cost     O(moves) for paths in the same order, at worst the product of both numbers of moves.
[[nodiscard]] std::optional<PathDifference> measure_difference(const Toolpath& path, const Toolpath& other,
                                                               double height_mm, double within_mm);

/// A path whose tips are those of another one, times `factor`, then shifted.
struct PathRelation {
  double factor = 1;
  Vec3 shift_mm = Vec3::Zero();
};

/// Finds a mistake of unit or place: a factor of 25.4 or 1/25.4, or a shift, after which the feed positions of each path
/// lie within `within_mm` of the feeds of the other. Axes are not compared. Returns `other` as a relation of `path`; none:
/// no such relation is found, a path has fewer than three such positions, or the paths are the same as they are.
/// Cost     That of measure_difference for paths in the same order; less if there is no relation.
[[nodiscard]] std::optional<PathRelation> find_relation(const Toolpath& path, const Toolpath& other, double within_mm);

}  // namespace gouge
