#pragma once

#include <span>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Checks one motion of one tool: everything but "buried", which needs the moves before it (check_path.h).
///
/// Requires motion.is_defined().
/// Ensures  The guarantee of docs/method/guarantee.md: depth <= true depth <= depth_upper. A gouge is closed to the
///          resolution. Clean means depth_upper <= tolerance + resolution. It also means that no body with a clearance
///          is entered, and no mesh with limits (MeshLimit) exceeds them, by more than the resolution. For a gouge
///          against such a mesh the witness and the depth are of that mesh; depth_upper is of all. Unless
///          options.is_depth_alone, it also means depth_upper <= certified_depth; a move that exceeds this alone is
///          not_certified. A budget that runs out gives not_certified, never clean. Coordinates of the motion or of a
///          mesh beyond kFarthest_mm, or that are not numbers, give not_checked.
/// Source   docs/method/certified_sweep.md; depth as in Ho 1999, thesis 2.4.18.
[[nodiscard]] MoveVerdict check_move(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                     const PreparedScene& scene, const CheckOptions& options,
                                     std::uint64_t* bounds = nullptr);

/// Checks moves of one tool, one after the other on the path, together. This is much faster than one by one, since what
/// is far from all of them is discarded once.
///
/// Shape    One kind and one verdict a motion.
/// Requires and ensures as check_move. A verdict may differ from check_move's in the last digits of depth_upper, since
/// the moves share bounds. Where `bounds` is given, it has one count a motion, to which the work is added.
void check_moves(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                 const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                 std::span<std::uint64_t> bounds);

}  // namespace gouge
