#pragma once

#include <cstddef>
#include <optional>

#include "lib/geom/pose.h"
#include "lib/verify/claims.h"

// Poses of the tool and of its heads, by the law of motion of a claim. This module has its own formulas.

namespace gouge {

/// Returns the pose at t in [0, 1] of a move. It follows the rotary joints if the claim names them for this kind of
/// motion and the path has their angles. Otherwise it follows the great circle. `turn` states where the rotary joints are,
/// for a law that admits several motions. Requires a law that admits it.
[[nodiscard]] Pose claimed_pose(const ClaimedScene& scene, std::size_t move, double t,
                                const std::optional<TurnShares>& turn = {});

/// Returns the frame of the bodies that move with the tool at t. With rotary joints it is the frame of the joints.
/// Otherwise docs/method/guarantee.md defines it. At a position the part's z axis turns the shortest way to the tool
/// axis. Between positions it follows the great circle, and the rest of the turn is evenly distributed.
[[nodiscard]] RigidTransform head_frame(const ClaimedScene& scene, std::size_t move, double t,
                                        const std::optional<TurnShares>& turn = {});

/// Returns whether the law of a move admits these places of the rotary joints at t.
[[nodiscard]] bool admits(const ClaimedScene& scene, std::size_t move, double t, const TurnShares& turn);

/// Returns how the tool runs on a move; on_circle too where its angles are not known.
[[nodiscard]] ClaimedRun claimed_run_of(const ClaimedScene& scene, std::size_t move);

/// Returns the first move whose angles do not give the tool axes of the file at both ends; nothing if all do.
[[nodiscard]] std::optional<std::size_t> find_wrong_joints(const ClaimedScene& scene);

}  // namespace gouge
