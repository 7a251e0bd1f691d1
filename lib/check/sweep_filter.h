#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/check/search.h"
#include "lib/check/sweep_frame.h"
#include "lib/motion/motion.h"
#include "lib/tool/convex_cover.h"

// The wide sweep: many moves against a surface at once. Motions that sixteen-wide bounds in single precision prove free
// need no further search. The triangles that remain go to the exact search (search.h). Method and proofs:
// docs/method/wide_sweep.md.

namespace gouge {

/// Result of the wide sweep for one query about one move.
struct SweptMove {
  SearchStart start;
  std::uint64_t bounds = 0;  ///< blocks examined; those examined for a group count for its first move
};

/// Sweeps every motion against every target, for one query (search.h).
/// Requires motions that are defined. Tools without elements and empty trees are passed over.
/// Ensures  Each result depends on `motions` alone, not on the processor or on who else runs.
/// Cost     A microsecond or two for a motion along a surface, a tenth of that for one far from it.
[[nodiscard]] std::vector<SweptMove> sweep_moves(std::span<const Motion> motions,
                                                 const std::vector<SearchTarget>& targets, const SearchQuery& query,
                                                 const SweepKernel& kernel = fastest_sweep_kernel());

/// A cover against a surface. `tool` is the tool inside the cover, which is measured where it is deepest. With null
/// nothing is measured, and the undecided rest of a move has no value.
struct CoverTarget {
  const ConvexCover* cover = nullptr;
  const BlockTree* tree = nullptr;
  const CompiledTool* tool = nullptr;
  double reach_mm = 0;  ///< of SearchTarget
};

/// Returns the same for covers that were made before, and of other bodies than tools.
[[nodiscard]] std::vector<SweptMove> sweep_covers(std::span<const Motion> motions, std::span<const CoverTarget> targets,
                                                  const SearchQuery& query,
                                                  const SweepKernel& kernel = fastest_sweep_kernel());

}  // namespace gouge
