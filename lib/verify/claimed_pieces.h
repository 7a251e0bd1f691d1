#pragma once

#include <optional>
#include <vector>

#include "lib/verify/claims.h"
#include "lib/verify/moving_pose.h"

namespace gouge {

/// Returns the pieces of a move by the law of its claim; of a law that admits two motions, those of both. Nothing of a law
/// that is not evaluated here, of any motion of the rotary joints, or without the angles of the joints.
/// Requires  RoundsUpward.
[[nodiscard]] std::optional<std::vector<MotionPiece>> claimed_pieces(const ClaimedScene& scene, std::size_t move);

/// A piece of motion: its move, and its index among the pieces of that move.
struct PieceOfMove {
  std::size_t move = 0, index = 0;
};

struct MotionOfMoves {
  std::vector<MotionPiece> motion;
  std::vector<PieceOfMove> of_piece;  ///< one for each piece
};

/// Returns the pieces of consecutive moves; nothing: a motion is not defined. Requires RoundsUpward.
[[nodiscard]] std::optional<MotionOfMoves> pieces_of_moves(const ClaimedScene& scene, std::size_t first,
                                                           std::size_t count);

}  // namespace gouge
