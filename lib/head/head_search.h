#pragma once

#include <cstdint>
#include <span>

#include "lib/base/best_first_search.h"
#include "lib/check/search.h"
#include "lib/head/head_body.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/motion/body_motion.h"

namespace gouge {

/// A surface from which a head must keep clear.
struct HeadTarget {
  const BlockTree* tree = nullptr;
  double reach_mm = 0;  ///< clearance: the search maximizes reach - signed distance
};

/// The largest depth of a surface in a head during one motion.
struct HeadResult {
  double depth_mm = 0;        ///< depth of the witness; at least 0
  double depth_upper_mm = 0;  ///< proved upper bound of the depth in the whole move
  bool has_witness = false;   ///< depth > 0
  double t = 0;
  Vec3 point = Vec3::Zero();    ///< a surface point, in part coordinates
  Vec3 normal = Vec3::UnitZ();  ///< direction in which the head must move away by the depth
  std::size_t target = 0;       ///< index of the queried target
  std::uint32_t triangle = 0;   ///< triangle in the target's tree
  std::uint64_t bounds = 0;
};

/// Searches best first (best_first_search.h) over (interval of time x part of the surface). It first tries planes that
/// have the whole head below them, beginning with those that bounded other parts. In the tool's frame a point of the
/// surface stays within `bulge` of the chord between its positions at both ends of an interval. The head's signed
/// distance is 1-Lipschitz. So over the interval and a ball about the point, it is at least half of (sum at both ends -
/// path length) - radius.
///
/// Requires resolution > 0, gap > 0 and no negative reach.
/// Ensures  At any budget, depth <= true depth <= depth_upper.
/// Source   Space-time bounds, thesis 2.4.14; chord and bulge as in docs/method/certified_sweep.md.
[[nodiscard]] HeadResult search_head(const BodyMotion& motion, const HeadBody& head,
                                     std::span<const HeadTarget> targets, const SearchGoal& goal);

/// Does the same for the remainder in `start`. Its seeds name a target and a triangle of the target's tree. Its value
/// is not used.
[[nodiscard]] HeadResult search_head(const BodyMotion& motion, const HeadBody& head,
                                     std::span<const HeadTarget> targets, const SearchGoal& goal,
                                     const SearchStart& start);

}  // namespace gouge
