#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/check/search.h"
#include "lib/check/sweep_frame.h"
#include "lib/motion/motion.h"
#include "lib/tool/convex_cover.h"

// The wide sweep compares many moves with a surface at once. Its bounds in single precision are computed sixteen at a
// time; a motion that they prove free needs no further search. The remaining triangles go to the exact search
// (search.h). Method and proofs: docs/method/wide_sweep.md.

namespace gouge {

/// Result of the wide sweep for one query about one move.
struct SweptMove {
  SearchStart start;
  std::uint64_t bounds = 0;  ///< number of examined blocks; those of a group count for its first move
};

/// Sweeps every motion against every target, for one query (search.h).
/// Requires motions that are defined. Tools without elements and empty trees are ignored.
/// Ensures  Each result depends only on `motions` and the other arguments, not on the processor or on other threads.
/// Cost     A microsecond or two for a motion along a surface, a tenth of that for one far from it.
[[nodiscard]] std::vector<SweptMove> sweep_moves(std::span<const Motion> motions,
                                                 const std::vector<SearchTarget>& targets, const SearchQuery& query,
                                                 const SweepKernel& kernel = fastest_sweep_kernel());

/// A cover and a surface. `tool` is the tool inside the cover; it is measured at the deepest points. If it is null
/// nothing is measured, and the undecided rest of a move has no value.
struct CoverTarget {
  const ConvexCover* cover = nullptr;
  const BlockTree* tree = nullptr;
  const CompiledTool* tool = nullptr;
  double reach_mm = 0;  ///< as SearchTarget::reach_mm
};

/// Returns the same result for given covers, also for covers of bodies that are not tools.
[[nodiscard]] std::vector<SweptMove> sweep_covers(std::span<const Motion> motions, std::span<const CoverTarget> targets,
                                                  const SearchQuery& query,
                                                  const SweepKernel& kernel = fastest_sweep_kernel());

}  // namespace gouge
