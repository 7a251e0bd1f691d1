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

}  // namespace gouge
