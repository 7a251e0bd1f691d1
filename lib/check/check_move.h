#pragma once

#include <span>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Checks one motion of one tool for every state except "buried", which needs the moves before it (check_path.h). If the
/// law admits several motions for the move, the verdict covers all of them: the worst state and the deepest witness
/// stay.
///
/// Requires motion.is_defined().
/// Ensures  The guarantee of docs/method/guarantee.md: depth <= true depth <= depth_upper. For a gouge the two depths
///          differ by at most the resolution. Clean means depth_upper <= tolerance + resolution. It also means that no
///          body with a clearance is entered, and no mesh exceeds its limits (MeshLimit), by more than the resolution.
///          For a gouge against a mesh with limits, the witness and the depth are those of the mesh; depth_upper covers
///          all meshes. Unless options.is_depth_alone is set, clean also means depth_upper <= certified_depth; a move
///          that exceeds only this is not_certified. A budget that runs out gives not_certified, never clean.
///          With LawScope::any the depths of a gouge may differ by more, and near misses are those of `motion` itself.
///          Coordinates of the motion or of a mesh that are beyond kFarthest_mm, or are not numbers, give not_checked.
/// Source   docs/method/certified_sweep.md; depth as in Ho 1999, thesis 2.4.18.
[[nodiscard]] MoveVerdict check_move(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                     const PreparedScene& scene, const CheckOptions& options,
                                     std::uint64_t* bounds = nullptr);

/// Checks several moves of one tool together, in path order. This is much faster than one by one, because a triangle
/// that is far from all of them is discarded once.
///
/// Shape    One kind and one verdict for each motion.
/// Requires and ensures the same as check_move. A verdict may differ from check_move's in the last digits of
/// depth_upper, because the moves share bounds. If `bounds` is given, it has one count for each motion, to which the
/// work is added.
void check_moves(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                 const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                 std::span<std::uint64_t> bounds);

}  // namespace gouge
