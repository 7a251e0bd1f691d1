#pragma once

#include <cstddef>
#include <optional>

#include "lib/base/tolerance.h"
#include "lib/path/toolpath.h"

// Measures the smoothness of the tool axis along a path, and its cost in time: docs/method/correction.md, "Quality".

namespace gouge {

/// The largest value over moves, and the first move that has it.
struct LargestOfMoves {
  double value = 0;
  std::size_t move = kNone;  ///< kNone if `value` is 0

  void take(double of_move, std::size_t index);
};

/// Smoothness of the tool axis over the feed moves of a path that have a start.
struct AxisQuality {
  LargestOfMoves turn_rad_per_mm;     ///< turn divided by the length of the tip's path; turns on the spot have no such
                                      ///< value
  LargestOfMoves turn_rad;            ///< turn in one move, on the spot or not
  std::size_t turns_on_the_spot = 0;  ///< number of moves of at most kSpot_mm that turn
  LargestOfMoves turn_on_the_spot_rad;
  /// J, the discrete integral of |u''|^2 in rad^2/mm^3, where u is the unit axis over the length of the tip's path. The
  /// sum is over neighbouring feed moves. Its terms are |du(i+1)/ds(i+1) - du(i)/ds(i)|^2 * 2 / (ds(i) + ds(i+1)).
  double bending = 0;
  double feed_seconds = 0;                     ///< time at the programmed feeds
  std::optional<double> limited_feed_seconds;  ///< time that also keeps the rotary limit; none: no limit is given
  std::size_t moves_without_feed = 0;          ///< number of moves in neither time, because no feed per minute is known

  /// Length below which a file cannot state a position more precisely.
  static constexpr double kSpot_mm = 0.001;
  /// Angle up to which axes are equal, apart from the digits of a file.
  static constexpr double kSameAxis_rad = Tolerance::kFileAxis;

  [[nodiscard]] bool has_turns() const { return turn_rad.value > kSameAxis_rad; }
};

/// Measures the turns of the tool axis along a path. The limit `max_rotary_rad_per_s`, above 0, is on the turn of the
/// axis itself. Each move takes the longer of its time at the programmed feed and the time of its turn at the limit. A
/// machine whose axes turn farther than the tool's axis is slower than that.
///
/// J joins moves that follow one another without a rapid or a gap. A move of at most kSpot_mm is left out of it. If it
/// does not turn, its neighbours count as consecutive. If it turns, J would be infinite, so J ends and begins anew. An
/// even turn of w rad/mm on a great circle has w^4 per mm, the minimum that a unit axis can have.
/// Cost: one pass over the moves.
[[nodiscard]] AxisQuality measure_axis_quality(const Toolpath& path,
                                               std::optional<double> max_rotary_rad_per_s = std::nullopt);

}  // namespace gouge
