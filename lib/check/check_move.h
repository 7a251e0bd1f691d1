#pragma once

#include <span>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Checks one motion of one tool; everything but "buried", which needs the moves before it (check_path.h).
///
/// Requires motion.is_defined().
/// Ensures  The guarantee of docs/method/guarantee.md: depth <= true depth <= depth_upper; a gouge is closed to the resolution;
///          clean means depth_upper <= tolerance + resolution, and no body with a clearance entered by more than the
///          resolution, and no mesh with limits (MeshLimit) beyond them by more than the resolution; of a gouge against
///          such a mesh the witness and the depth are of that mesh, depth_upper is of all;
///          and depth_upper <= certified_depth unless options.is_depth_alone: what lies between is
///          not_certified. A budget that runs out gives not_certified, never clean. Coordinates of the motion or of a
///          mesh beyond kFarthest_mm, or that are no numbers, give not_checked.
/// Source   docs/method/certified_sweep.md; depth as in Ho 1999, thesis 2.4.18.
[[nodiscard]] MoveVerdict check_move(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                     const PreparedScene& scene, const CheckOptions& options,
                                     std::uint64_t* bounds = nullptr);

/// Moves of one tool, one after the other on the path, checked together: much faster than one by one, since
/// what is far from all of them is discarded once.
///
/// Shape    One kind and one verdict a motion. Requires and ensures as check_move; a verdict may differ from
///          check_move's in the last digits of depth_upper, since the moves share bounds.
/// `bounds`, where given, has one count a motion, to which the work is added.
void check_moves(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                 const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                 std::span<std::uint64_t> bounds);

}  // namespace gouge
