#pragma once

#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/motion.h"
#include "lib/check/scene.h"
#include "lib/check/verdict.h"
#include "lib/hierarchy/surface_tree.h"

namespace gouge {

/// The scene with its trees.
struct PreparedScene {
  const Scene* scene = nullptr;
  SurfaceTree parts, fixtures;
};

[[nodiscard]] PreparedScene prepare_scene(const Scene& scene);

/// Checks one motion of one tool; everything but "buried", which needs the moves before it (check_path.h).
///
/// Requires motion.is_defined().
/// Ensures  the promise of docs/method.md: depth <= true depth <= depth_upper; a gouge is closed to the
/// resolution;
///          clean means depth_upper <= tolerance + resolution, and no body with a clearance entered by more
///          than the resolution. A budget that runs out gives not_certified, never clean.
/// Source   docs/algorithms/certified_sweep.md; depth as in Ho 1999, thesis 2.4.18.
[[nodiscard]] MoveVerdict check_move(const Motion& motion, MoveKind kind, const ToolForms& tool,
                                     const PreparedScene& scene, const CheckOptions& options,
                                     std::uint64_t* bounds = nullptr);

}  // namespace gouge
