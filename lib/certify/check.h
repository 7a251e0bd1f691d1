#pragma once

#include <vector>

#include "lib/base/checkpoints.h"
#include "lib/base/parallel.h"
#include "lib/certify/assess.h"
#include "lib/certify/settle_stock.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"

// The only entry point for a verdict. It takes all inputs together, so that no caller can leave one out. The modules of
// a check (lib/check, lib/head, lib/overcut) are closed to all other modules; tests/architecture ensures it.

namespace gouge {

/// All inputs of a check except the path. The objects that it refers to must outlive it.
struct CheckSetup {
  std::vector<const ToolVariants*> tools;  ///< one per Toolpath::tools; null or missing: that tool has no definition
  const std::vector<HeadBody>& heads;      ///< bodies that move with the tool; may be empty
  const PreparedScene& scene;              ///< parts and fixtures
  const CheckOptions& options;
  CheckpointStore* kept = nullptr;    ///< store of an earlier run of exactly the same check, or null
  SetupBasis basis = {};              ///< facts about the inputs
  const StockSetup* stock = nullptr;  ///< null: moves are not checked against remaining stock
};

/// Checks every move of a path: tools and heads, against parts and fixtures, for contact and for the side. Measures how
/// far the gouges reach below the surface. Lists the facts on which the verdict rests.
///
/// Ensures  (1) CheckResult is complete: one verdict for each move, in order, with the overcut of a gouge; events and
///          counts. (2) A move is clean only if every body of the tool and every head is proved outside of all solids
///          during it. Each must also be proved no deeper than tolerance + resolution. A move is buried only if one of
///          them is proved inside. A move that is rejected, left out or beyond the budget is not checked or not
///          certified, and has the reason. (3) The assumptions of the path, of `setup.basis` and of the check itself
///          are settled (lib/path/assumption.h). (4) The result is the same, bit for bit, at any number of threads.
/// Cost     That of check_path, check_heads, measure_overcuts and assess.
[[nodiscard]] CheckResult check(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress = {});

/// Checks only the moves, for searches that try many paths. Ensures (1), (2) and (4) of check. Its result has no
/// assumptions, so no report may be made of it.
[[nodiscard]] CheckResult check_moves(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress = {});

}  // namespace gouge
