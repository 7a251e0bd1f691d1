#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lib/verify/bounds.h"
#include "lib/verify/claimed_chain.h"

// The joints of a machine in interval arithmetic: what a proof needs of a law of motion. Formulas and proofs:
// docs/method/verify.md, "Poses". Every function requires RoundsUpward.

namespace gouge {

/// Pose of the tool at one instant, or at any of several.
struct PoseBounds {
  Bounds3 tip, axis;

  /// Returns the pose in their middle, in plain numbers.
  [[nodiscard]] Pose middle() const { return {tip.middle(), axis.middle().normalized()}; }
};

inline constexpr std::size_t kChainJoints = 5;
using ChainValues = std::array<Bounds, kChainJoints>;

/// A piece of time in which each joint runs evenly. `joints` must outlive it.
struct ChainSpan {
  const ClaimedJoints* joints = nullptr;
  std::array<ChainValues, 2> values;  ///< at its start and end
  bool moves_tip = false;             ///< false: the tip runs as the path states
  double slack_mm = 0, slack = 0;     ///< tip and axis may be off by so much more: arrivals are rounded

  [[nodiscard]] PoseBounds pose(std::size_t end) const;
  /// Return upper bounds of |tip''| and |axis''|, with the span's time running from 0 to 1.
  [[nodiscard]] Bounds tip_acceleration() const;
  [[nodiscard]] Bounds axis_acceleration() const;
  [[nodiscard]] std::array<ChainSpan, 2> halves() const;
};

/// Returns the values of all joints for a tip; none where it is not proved that there is one solution.
/// Requires five joints and finite numbers.
[[nodiscard]] std::optional<ChainValues> chain_values(const ClaimedJoints& joints, const RotaryAngles& angles,
                                                      const Vec3& tip);

/// Returns the values at a share of the way, all joints running together.
[[nodiscard]] ChainValues values_at(const ChainValues& from, const ChainValues& to, const Bounds& share);

/// Returns the pieces of a motion of all joints; none where a rate is not known. `run`: together or independent.
[[nodiscard]] std::optional<std::vector<ChainSpan>> chain_spans(const ClaimedJoints& joints, ClaimedRun run,
                                                                const ChainValues& from, const ChainValues& to);

}  // namespace gouge
