#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/joint_angles.h"
#include "lib/path/toolpath.h"

// The joints of a machine as a claim names them, by formulas of this module's own: 4x4 matrices.

namespace gouge {

/// Distances and angles below which a joint does not move: docs/method/machine.md.
inline constexpr double kClaimedStand_mm = 1e-9, kClaimedStand_rad = 1e-12;

struct ClaimedJoint {
  bool is_rotary = false;
  Vec3 direction = Vec3::UnitX();  ///< unit
  Vec3 point = Vec3::Zero();       ///< on a rotary axis, mm
  std::optional<double> rate;      ///< mm or rad per minute
};

/// Runs of the tool between two positions.
enum class ClaimedRun : std::uint8_t {
  on_circle,    ///< the tip as the path states, the axis on the great circle
  rotary,       ///< the tip as the path states, both rotary joints evenly
  together,     ///< all joints evenly; the tip on a curve of the path where rotary joints stand
  independent,  ///< each joint at its own rate until it arrives
  documented,   ///< on_circle and rotary; a bound must hold for both
  any           ///< as for rotary, but with the rotary joints anywhere between their ends at every instant
};

/// Joints from the part to the tool, in place of the great circle.
struct ClaimedJoints {
  std::vector<ClaimedJoint> chain;
  std::array<std::size_t, 2> rotary{};  ///< of `chain`, that nearer to the part first
  double tool_length_mm = 0;
  RigidTransform rest;  ///< frame of the tool with all joints at 0: gauge point, and the tool axis as z
  ClaimedRun feeds = ClaimedRun::on_circle, rapids = ClaimedRun::on_circle;
  /// Runs of moves without tool centre point control (Move::runs_joints).
  ClaimedRun joint_feeds = ClaimedRun::together, joint_rapids = ClaimedRun::together;
};

/// Returns the run of a move with a start.
[[nodiscard]] ClaimedRun run_of(const ClaimedJoints& joints, const Move& move);

/// Both ends of a motion: tips and rotary angles.
struct ChainEnds {
  Vec3 tip0, tip1;
  RotaryAngles angles0{}, angles1{};
};

/// Returns the frame of the tool at t in [0, 1]: origin at the tip, z along the axis. Requires a run that is not on_circle.
/// For `rotary`, only the rotation has a meaning. A joint without a rate runs evenly.
[[nodiscard]] RigidTransform chain_frame(const ClaimedJoints& joints, ClaimedRun run, const ChainEnds& ends, double t);

}  // namespace gouge
