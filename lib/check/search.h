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
// wide sweep (sweep_filter.h) could not decide. Method and proofs: docs/method/certified_sweep.md. It extends thesis
// 2.4.18, which examines points at single poses.

namespace gouge {

/// A form of the tool and the tree of a surface that it is compared with.
struct SearchTarget {
  const CompiledTool* tool = nullptr;
  const BlockTree* tree = nullptr;
  Against against = Against::part;
  double reach_mm = 0;           ///< addition to the query's reach: the clearance to keep from this surface
  std::uint32_t first_mesh = 0;  ///< index within its obstacle of the first mesh of the tree
};

/// Returns the target of a tool form and all meshes of an obstacle. Both must outlive it.
[[nodiscard]] inline SearchTarget target_on(const CompiledTool& form, const PreparedObstacle& obstacle) {
  return {&form, &obstacle.tree, obstacle.rule.against};
}

/// Returns the target of a tool form and one mesh. A value above 0 is the length by which the clearance is entered.
[[nodiscard]] inline SearchTarget target_on(const CompiledTool& form, const LimitedMesh& mesh) {
  return {&form, mesh.tree, mesh.limit.against, mesh.limit.clearance_mm, static_cast<std::uint32_t>(mesh.limit.mesh)};
}

struct SearchQuery : SearchGoal {
  /// The search maximizes `reach_mm - signed distance`. 0 gives the depth; a near-miss distance gives the closest
  /// approach.
  double reach_mm = 0;
};

/// A triangle in the tree of a target.
struct SearchSeed {
  std::uint32_t target = 0, triangle = 0;
};

/// Start of a search: the known bounds of the move.
struct SearchStart {
  std::vector<SearchSeed> seeds;  ///< the triangles to examine; all others are pruned
  double certified_mm = 0;        ///< proved upper bound of the value on all other triangles
  double value_mm = 0;            ///< value at a real point and instant; 0: none found
  double t = 0;
  Vec3 point = Vec3::Zero();
  SearchSeed at;  ///< place of the value
};

struct SearchResult {
  double value_mm = 0;        ///< largest value found at a real point and instant, at least 0
  double value_upper_mm = 0;  ///< proved upper bound of the value in the whole move
  bool has_witness = false;   ///< value > 0
  double t = 0;
  Vec3 point = Vec3::Zero();
  SearchSeed at;             ///< the triangle of the point
  bool is_decided = true;    ///< false: the budget ran out first; value_upper is still valid
  std::uint64_t bounds = 0;  ///< number of computed bounds
};

/// Searches for the largest value during one move. Requires motion.is_defined(), resolution > 0 and gap > 0. Tools
/// without elements are ignored.
/// Ensures  The true value lies in [value, value_upper]. When decided, value_upper is at most tolerance + resolution, or,
///          with a value above the tolerance, at most the larger of value + gap and tolerance + resolution.
/// Cost     A few hundred bounds for a clean move near the surface; no allocation outlives the call.
[[nodiscard]] SearchResult search_move(const Motion& motion, const std::vector<SearchTarget>& targets,
                                       const SearchQuery& query, const SearchStart& start);

/// Sweeps one motion (sweep_filter.h) and then searches it until it is decided.
[[nodiscard]] SearchResult sweep_and_search(const Motion& motion, const std::vector<SearchTarget>& targets,
                                            const SearchQuery& query);

}  // namespace gouge
