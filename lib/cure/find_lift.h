#pragma once

#include <optional>
#include <vector>

#include "lib/certify/check.h"

namespace gouge {

/// Lift that some moves need along the tool axis.
struct LiftCure {
  std::optional<double> lift_mm;  ///< the smallest multiple of the step that was found; none: no lift up to the maximum
  /// The obstacle one step below, or at the maximum: its move, its body, and its state (gouge, buried, or not
  /// certified).
  std::size_t move = kNone;
  Body body = Body::holder;
  MoveState state = MoveState::gouge;
  /// Proved: no multiple of the step below this frees the moves. If it equals `lift_mm`, that lift is the minimum.
  /// Lifts between the two are not decided.
  double not_free_below_mm = 0;

  [[nodiscard]] bool is_least() const { return lift_mm && !(not_free_below_mm < *lift_mm); }
};

/// Moves of a path, lifted along the tool axis of each position. Moves that follow without a gap stay consecutive
/// motions. A curve keeps its form, but if the axis turns along it, it is replaced by chords within `chord_error_mm`.
struct LiftedMoves {
  Toolpath path;                    ///< path without source text
  std::vector<std::size_t> origin;  ///< for each move its index in the original path; kNone: a single position at which
                                    ///< others begin
};
[[nodiscard]] LiftedMoves lift_moves(const Toolpath& path, const std::vector<std::size_t>& moves, double lift_mm,
                                     double chord_error_mm);

/// Finds the minimum lift, a multiple of `step_mm` up to `max_mm`, that frees the moves. With this lift check() finds
/// no body that gouges, is buried or is uncertain.
///
/// Requires moves in path order, of which at least one is not free.
/// Ensures  (1) The named move is not proved free one step below. (2) The height `not_free_below_mm` is proved by
///          buried tools and by real gouges. A gouge rules out all lifts that differ by less than its depth beyond the
///          permitted depth. Each next lift follows from the remaining depth. After 64 lifts, and where the check
///          decides nothing, lifts double and are then halved back. (3) If the check decided nothing one step below, up
///          to eight lower lifts get a whole check, by halving. Whole checks know the path to each move.
/// Cost     A check of the moves for each tried lift, some ten; a whole check at the end.
[[nodiscard]] LiftCure find_lift(const Toolpath& path, const std::vector<std::size_t>& moves, const CheckSetup& setup,
                                 double step_mm, double max_mm);

}  // namespace gouge
