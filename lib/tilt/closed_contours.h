#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "lib/tilt/tilt_run.h"

namespace gouge {

/// Where contours close: ends of two moves at which the tool stands alike in the programmed path, and nowhere between.
struct Seam {
  std::size_t begin = 0, end = 0;  ///< moves
};

/// Of all contours: ways of one tool's feeds that come back to a pose they were at before, bit for bit, looked for among
/// the ends of the moves named.
[[nodiscard]] std::vector<Seam> find_seams(const Toolpath& path, const std::vector<bool>& is_named);

/// Which tilts the runs of a path must have where contours close, so that what was closed stays closed: the tool stands
/// alike at both ends of a contour after tilting, too.
class ClosedContours {
 public:
  explicit ClosedContours(const TiltJob& job)
      : path_(job.path), seams_(find_seams(path_, moves_near(path_, job.is_wanted, job.options.blend_mm))) {}

  /// Runs that will be tilted next. Ends of contours that are in none of them, nor were before, stay as programmed.
  void begin(const std::vector<TiltRun>& runs);

  /// Gives positions at one end of a contour the axis that is known of its other end. False where none is.
  bool give_known(std::vector<TiltPosition>& positions) const;

  /// Positions at the two ends of one contour, both of this run.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> loops(
      const std::vector<TiltPosition>& positions) const;

  /// The tilts of a run that are taken.
  void learn(const TiltSpace& space, const TiltSequence& tilts);

 private:
  [[nodiscard]] static bool is_end(const TiltPosition& at, std::size_t move) { return at.move == move && !(at.t < 1); }

  const Toolpath& path_;
  std::vector<Seam> seams_;
  std::map<std::size_t, Vec3> programmed_, tilted_;  // axes at ends of moves, as far as they are known
};

}  // namespace gouge
