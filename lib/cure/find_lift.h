#pragma once

#include <optional>
#include <vector>

#include "lib/certify/check.h"

namespace gouge {

/// Lift that some moves need along the tool axis.
struct LiftCure {
  std::optional<double> lift_mm;  ///< the least multiple of the step found; none: none up to the most
  /// The obstacle one step below, or at the maximum: the move, the body and how, a gouge, buried, or not certified
  /// to be neither.
  std::size_t move = kNone;
  Body body = Body::holder;
  MoveState state = MoveState::gouge;
  /// Proved: no multiple of the step below this frees the moves. Where it is `lift_mm`, that is the least one. Lifts
  /// between both are not decided.
  double not_free_below_mm = 0;

  [[nodiscard]] bool is_least() const { return lift_mm && !(not_free_below_mm < *lift_mm); }
};

/// Moves of a path at some height, lifted along the tool axis of each position. Moves that follow without a gap stay
/// one motion after the other. A curve keeps its form. Where the axis turns along it, it becomes chords within
/// `chord_error_mm`.
struct LiftedMoves {
  Toolpath path;                    ///< no source
  std::vector<std::size_t> origin;  ///< of each move: of the path as it was; kNone: a position alone where others begin
};
[[nodiscard]] LiftedMoves lift_moves(const Toolpath& path, const std::vector<std::size_t>& moves, double lift_mm,
                                     double chord_error_mm);

/// Finds the least lift, a multiple of `step_mm` up to `max_mm`, that frees the moves. With it check() finds no gouge,
/// nothing buried and nothing uncertain, of any body.
///
/// Requires moves in path order, not all of them free as they are.
/// Ensures  (1) The named move is not proved free one step below. (2) The height `not_free_below_mm` is proved by
///          buried tools and by real gouges. Each gouge proves it for all lifts that differ by less than its depth
///          beyond the allowed one. Each lift follows from the depth that remains. After 64 of these, and where the
///          check decides nothing, lifts double, and are halved back. (3) Where the check decided nothing one step
///          below, whole checks are made of up to eight lifts below, by halving. These know the path to each move.
/// Cost     A check of the moves for each lift tried, some ten; a whole check at the end.
[[nodiscard]] LiftCure find_lift(const Toolpath& path, const std::vector<std::size_t>& moves, const CheckSetup& setup,
                                 double step_mm, double max_mm);

}  // namespace gouge
