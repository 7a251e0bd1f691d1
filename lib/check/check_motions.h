#pragma once

#include <span>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Checks several motions of one tool together, in path order, each as the only motion of its move. A triangle that is
/// far from all of them is discarded once.
///
/// Shape    One kind, one verdict and one count of bounds for each motion. The work is added to the counts.
/// Requires and ensures the same as check_moves, for one motion of a move.
void check_motions(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                   const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                   std::span<std::uint64_t> bounds);

}  // namespace gouge
