#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/check/sweep_kernel.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_interval.h"

// Motions to first order: of a part of a move, of a move, or of many moves in a row.
// Proofs: docs/method/wide_sweep.md, section 2.

namespace gouge {

/// A part of a motion: its ends, and how far tip and axis may leave what is straight between them.
struct SweepInterval : MotionInterval {
  Pose from, to;
  MotionRates rates;
  std::uint32_t move = 0;
};

/// Appends the steps of a motion: one where it is straight, more where it bends.
void append_steps(const Motion& motion, std::uint32_t move, std::vector<SweepInterval>& steps);

/// Returns the two halves of a step.
[[nodiscard]] std::array<SweepInterval, 2> halved(const Motion& motion, const SweepInterval& step);

/// Returns the frame that holds for every instant of every step, and for points up to `rounding_mm` beside the ones
/// they represent. Requires at least one step.
[[nodiscard]] SweepFrame sweep_frame(std::span<const SweepInterval> steps, const Vec3& origin, double rounding_mm);

}  // namespace gouge
