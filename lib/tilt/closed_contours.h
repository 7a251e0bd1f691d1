#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lib/tilt/tilt_run.h"

namespace gouge {

/// Two moves that end with the same pose in the programmed path, with no such move in between. They close a contour.
struct Seam {
  std::size_t begin = 0, end = 0;  ///< moves
};

/// Finds closed contours: sequences of feeds of one tool that return to an earlier pose, bit for bit. Only the ends of
/// moves with `is_named` count.
[[nodiscard]] std::vector<Seam> find_seams(const Toolpath& path, const std::vector<bool>& is_named);

/// The closed contours of a path, which stay closed while runs are tilted. After tilting, too, the tool has the same
/// pose at both ends of a contour.
class ClosedContours {
 public:
  /// The objects that `job` refers to must outlive it.
  explicit ClosedContours(const TiltJob& job);

  /// Starts a round with the runs that will be tilted next. Ends of contours that are in no run, now or in an earlier
  /// round, stay as programmed.
  void begin(const std::vector<TiltRun>& runs);

  /// Returns the positions of a run. If the axis at the other end of a contour is known, the position at this end gets
  /// the same axis. Returns nothing if no such axis is known.
  [[nodiscard]] std::optional<std::vector<TiltPosition>> with_known(const std::vector<TiltPosition>& positions) const;

  /// Returns the pairs of positions of this run that are the two ends of one contour, in the order of the path.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> loops(const TiltSpace& space) const;

  /// Records the accepted tilts of a run.
  void learn(const TiltSpace& space, const TiltSequence& tilts);

 private:
  [[nodiscard]] bool is_end(const TiltPosition& at) const { return !(at.t < 1) && other_end_.contains(at.move); }

  const Toolpath& path_;
  std::multimap<std::size_t, std::size_t> other_end_;  // moves; one lap may end where the next one begins
  std::map<std::size_t, Vec3> axes_;                   // at ends of moves; only the known ones
};

}  // namespace gouge
