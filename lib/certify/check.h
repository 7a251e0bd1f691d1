#pragma once

#include <vector>

#include "lib/base/checkpoints.h"
#include "lib/base/parallel.h"
#include "lib/certify/assess.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"

// The one entry to a verdict: it takes all its inputs together, so that no caller can leave one out. The
// parts themselves (lib/check, lib/head, lib/overcut) are closed to all other modules; tests/architecture ensures it.

namespace gouge {

/// All inputs of a check except the path. The objects referred to must outlive it.
struct CheckSetup {
  std::vector<const ToolVariants*> tools;  ///< one per Toolpath::tools; null or missing: that tool has no definition
  const std::vector<HeadBody>& heads;      ///< bodies that move with the tool; may be empty
  const PreparedScene& scene;              ///< parts and fixtures
  const CheckOptions& options;
  CheckpointStore* kept = nullptr;  ///< of an earlier run of the very same check, or null
  SetupBasis basis = {};            ///< how the inputs are known
};

/// Checks every move of a path: tools and heads, against parts and fixtures, from outside and from inside. Measures how
/// far below the surface the gouges reach. Lists what the verdict rests on.
///
/// Ensures  (1) The whole of CheckResult: one verdict a move, in order, with the overcut of a gouge; events and counts.
///          (2) A move is clean only if every body of the tool and every head is proved outside of all solids during
///          it. Each must also be proved no deeper than tolerance + resolution. It is buried only if one of them is
///          proved inside. A move that is refused, left out or beyond the budget is not checked or not certified, with
///          the reason. (3) The assumptions of the path, of `setup.basis` and of the check itself are settled
///          (lib/path/assumption.h). (4) The same result, bit for bit, at any number of threads.
/// Cost     That of check_path, check_heads, measure_overcuts and assess.
[[nodiscard]] CheckResult check(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress = {});

/// Checks the moves alone: (1), (2) and (4) of check, for searches that try many paths. Its result has no assumptions,
/// so no report may be made of it.
[[nodiscard]] CheckResult check_moves(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress = {});

}  // namespace gouge
