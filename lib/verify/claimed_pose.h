#pragma once

#include <cstddef>
#include <optional>

#include "lib/geom/pose.h"
#include "lib/verify/claims.h"

// Where the tool and its heads are, by the law of motion of a claim. Formulas of this module's own.

namespace gouge {

/// Returns the pose at t in [0, 1] of a move. By joints where the claim names them for its kind of motion and the path has
/// its angles, else on the great circle.
[[nodiscard]] Pose claimed_pose(const ClaimedScene& scene, std::size_t move, double t);

/// Returns the frame of the bodies that move with the tool at t. By joints it is theirs. Else, as
/// docs/method/guarantee.md states, at a position the part's z axis turned the shortest way to the tool's, in between on
/// the great circle, the rest of the turn spread evenly.
[[nodiscard]] RigidTransform head_frame(const ClaimedScene& scene, std::size_t move, double t);

/// Returns the first move whose angles do not give the tool axes of the file at both ends; none: all do.
[[nodiscard]] std::optional<std::size_t> find_wrong_joints(const ClaimedScene& scene);

}  // namespace gouge
