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
  /// Proved: no multiple of the step below this frees the moves. Where it is `lift_mm`, that is the least one; what is
  /// between both is not decided.
  double not_free_below_mm = 0;

  [[nodiscard]] bool is_least() const { return lift_mm && !(not_free_below_mm < *lift_mm); }
};

/// Moves of a path at some height: lifted along the tool axis of each position. What follows without a gap stays one
/// motion after the other; a curve keeps its form, or, where the axis turns along it, becomes chords within
/// `chord_error_mm`.
struct LiftedMoves {
  Toolpath path;                    ///< no source
  std::vector<std::size_t> origin;  ///< of each move: of the path as it was; kNone: a position alone where others begin
};
[[nodiscard]] LiftedMoves lift_moves(const Toolpath& path, const std::vector<std::size_t>& moves, double lift_mm,
                                     double chord_error_mm);

/// The least lift, a multiple of `step_mm` up to `max_mm`, with which check() of the moves finds no gouge, nothing
/// buried and nothing uncertain, of any body.
///
/// Requires moves in path order, not all of them free as they are.
/// Ensures  (1) The named move is not proved free one step below. (2) `not_free_below_mm` is proved by real gouges, each
///          for all lifts that differ by less than what it is deeper than allowed, and by buried tools. Lifts follow what
///          is missing; after 64 of these, and where the check decides nothing, they double, and are halved back.
///          (3) Where it decided nothing one step below, whole checks, which know the path to each move, are made of
///          up to eight lifts below, by halving.
/// Cost     A check of the moves for each lift tried, some ten; a whole check at the end.
[[nodiscard]] LiftCure find_lift(const Toolpath& path, const std::vector<std::size_t>& moves, const CheckSetup& setup,
                                 double step_mm, double max_mm);

}  // namespace gouge
