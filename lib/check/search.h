#pragma once

#include <cstdint>
#include <vector>

#include "lib/base/best_first_search.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/motion/motion.h"
#include "lib/tool/compiled_tool.h"

// The exact search of one move: best first (best_first_search.h) over (instant x triangle). Every step has a proved
// upper bound, and every candidate is a real point of a triangle at a real instant. It examines the triangles that the
// wide sweep (sweep_filter.h) could not decide. Method and proofs: docs/method/certified_sweep.md. Goes beyond thesis
// 2.4.18 (points at single poses).

namespace gouge {

/// A tool variant against a surface.
struct SearchTarget {
  const CompiledTool* tool = nullptr;
  const BlockTree* tree = nullptr;
  Against against = Against::part;
  double reach_mm = 0;           ///< added to the reach of the query: the clearance to keep from this surface
  std::uint32_t first_mesh = 0;  ///< index within its obstacle of the first mesh of the tree
};

/// Returns this form of a tool against all meshes of an obstacle. Both must outlive it.
[[nodiscard]] inline SearchTarget target_on(const CompiledTool& form, const PreparedObstacle& obstacle) {
  return {&form, &obstacle.tree, obstacle.rule.against};
}

/// Returns this form of a tool against one mesh; a value above 0 is a distance below its clearance.
[[nodiscard]] inline SearchTarget target_on(const CompiledTool& form, const LimitedMesh& mesh) {
  return {&form, mesh.tree, mesh.limit.against, mesh.limit.clearance_mm, static_cast<std::uint32_t>(mesh.limit.mesh)};
}

struct SearchQuery : SearchGoal {
  /// Searches for the largest `reach_mm - signed distance`: 0 for the depth, a near-miss distance for
  /// the closest approach.
  double reach_mm = 0;
};

/// A triangle of a target's tree.
struct SearchSeed {
  std::uint32_t target = 0, triangle = 0;
};

/// Start of a search: the known bounds of the move.
struct SearchStart {
  std::vector<SearchSeed> seeds;  ///< the triangles to examine; all others are pruned
  double certified_mm = 0;        ///< proven for the others: the value is no larger
  double value_mm = 0;            ///< met at a real point and instant; 0: none
  double t = 0;
  Vec3 point = Vec3::Zero();
  SearchSeed at;  ///< where the value was met
};

struct SearchResult {
  double value_mm = 0;        ///< largest value met at a real point and instant, at least 0
  double value_upper_mm = 0;  ///< proven: nowhere in the move is it larger
  bool has_witness = false;   ///< value > 0
  double t = 0;
  Vec3 point = Vec3::Zero();
  SearchSeed at;             ///< the triangle the point lies on
  bool is_decided = true;    ///< false: the budget ran out first; value_upper is still true
  std::uint64_t bounds = 0;  ///< how many were computed
};

/// Requires motion.is_defined(), resolution and gap > 0. Tools without elements are passed over.
/// Ensures  The true value lies in [value, value_upper]. When decided, value_upper is at most tolerance + resolution, or,
///          with a value above the tolerance, at most the larger of value + gap and tolerance + resolution.
/// Cost     A few hundred bounds for a clean move near the surface, no allocation that outlives the call.
[[nodiscard]] SearchResult search_move(const Motion& motion, const std::vector<SearchTarget>& targets,
                                       const SearchQuery& query, const SearchStart& start);

/// Sweeps one motion (sweep_filter.h) and searches it to the end.
[[nodiscard]] SearchResult sweep_and_search(const Motion& motion, const std::vector<SearchTarget>& targets,
                                            const SearchQuery& query);

}  // namespace gouge
