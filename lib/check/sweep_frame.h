#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/check/sweep_kernel.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_interval.h"

// First-order descriptions of motions: of a part of a move, of a move, or of many consecutive moves.
// Proofs: docs/method/wide_sweep.md, section 2.

namespace gouge {

/// A part of a motion: its ends, and how far tip and axis may deviate from straight motion between them.
struct SweepInterval : MotionInterval {
  Pose from, to;
  MotionRates rates;
  std::uint32_t move = 0;
};

/// Appends the steps of a motion: one for a straight segment, more for a bent one.
void append_steps(const Motion& motion, std::uint32_t move, std::vector<SweepInterval>& steps);

/// Returns the two halves of a step.
[[nodiscard]] std::array<SweepInterval, 2> halved(const Motion& motion, const SweepInterval& step);

/// Returns the frame that holds for every instant of every step, and for points up to `rounding_mm` away from the
/// represented ones. Requires at least one step.
[[nodiscard]] SweepFrame sweep_frame(std::span<const SweepInterval> steps, const Vec3& origin, double rounding_mm);

}  // namespace gouge
