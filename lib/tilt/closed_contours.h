#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lib/tilt/tilt_run.h"

namespace gouge {

/// Closing points of contours: ends of two moves with one pose of the tool in the programmed path, and none between.
struct Seam {
  std::size_t begin = 0, end = 0;  ///< moves
};

/// Finds closed contours: sequences of one tool's feeds that return to an earlier pose, bit for bit. They are searched
/// among the ends of the moves named.
[[nodiscard]] std::vector<Seam> find_seams(const Toolpath& path, const std::vector<bool>& is_named);

/// Tilts that runs of a path need so that closed contours stay closed. The tool has the same pose at both ends of a
/// contour after tilting, too.
class ClosedContours {
 public:
  /// The objects that `job` refers to must outlive it.
  explicit ClosedContours(const TiltJob& job);

  /// Begins with the runs that will be tilted next. Ends of contours that are in none of them, nor were before, stay as
  /// programmed.
  void begin(const std::vector<TiltRun>& runs);

  /// Returns the positions of a run. At one end of a contour they have the axis that is known of its other end. Nothing
  /// where none is known.
  [[nodiscard]] std::optional<std::vector<TiltPosition>> with_known(const std::vector<TiltPosition>& positions) const;

  /// Returns pairs of positions at the two ends of one contour, both of this run; in the order of the path.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> loops(const TiltSpace& space) const;

  /// Learns the tilts of a run that are taken.
  void learn(const TiltSpace& space, const TiltSequence& tilts);

 private:
  [[nodiscard]] bool is_end(const TiltPosition& at) const { return !(at.t < 1) && other_end_.contains(at.move); }

  const Toolpath& path_;
  std::multimap<std::size_t, std::size_t> other_end_;  // moves; a lap may end where the next begins
  std::map<std::size_t, Vec3> axes_;                   // at ends of moves, as far as they are known
};

}  // namespace gouge
