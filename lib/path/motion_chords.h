#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lib/path/toolpath.h"

// Motions of a toolpath as straight pieces, for comparisons of two paths.

namespace gouge {

/// A straight motion, or a chord of a curved one.
struct MotionChord {
  Pose from, to;
  std::size_t move = 0;

  [[nodiscard]] double length_mm() const { return (to.tip - from.tip).norm(); }
};

/// Returns whether a move is a feed that is checked.
[[nodiscard]] bool is_checked_feed(const Move& move);

/// Returns a move as straight pieces: chords of an arc or a spline within 0.0001 mm, or one piece. A move without a start
/// is one that stays at its end.
[[nodiscard]] std::vector<MotionChord> chords_of_move(const Toolpath& path, std::size_t move);
/// Returns the feeds that are checked, with arcs and splines as chords.
[[nodiscard]] std::vector<MotionChord> chords_of_feeds(const Toolpath& path);
/// Returns the rapids whose end is known. They include rapids whose motion is not known, as straight lines.
[[nodiscard]] std::vector<MotionChord> chords_of_rapids(const Toolpath& path);

/// Distance of a pose from the nearest point of a motion.
struct PoseDistance {
  double tip_mm = std::numeric_limits<double>::infinity(), axis_rad = 0;

  /// Returns the distance with an angle of 1 rad counted as `height_mm`.
  [[nodiscard]] double sum(double height_mm) const { return tip_mm + height_mm * axis_rad; }
  /// Returns whether neither the tip nor a point at `height_mm` on the axis is farther than `within_mm`.
  [[nodiscard]] bool is_within(double within_mm, double height_mm) const {
    return tip_mm <= within_mm && height_mm * axis_rad <= within_mm;
  }
};

/// The axis is that of the great circle at the nearest tip; where the tip rests, the nearest one of the turn.
[[nodiscard]] PoseDistance distance_from(const Pose& pose, const MotionChord& chord);
/// Returns a lower bound of the distance of the tip.
[[nodiscard]] double tip_bound_mm(const Pose& pose, const MotionChord& chord);

}  // namespace gouge
