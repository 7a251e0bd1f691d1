#pragma once

#include <cstdint>
#include <span>

#include "lib/base/best_first_search.h"
#include "lib/check/search.h"
#include "lib/head/head_body.h"
#include "lib/hierarchy/block_tree.h"
#include "lib/motion/body_motion.h"

namespace gouge {

/// A surface that a head must keep clear of.
struct HeadTarget {
  const BlockTree* tree = nullptr;
  double reach_mm = 0;  ///< the clearance: the search is for the largest reach - signed distance
};

/// The largest depth of a surface in a head along one motion.
struct HeadResult {
  double depth_mm = 0;        ///< realised at the witness; at least 0
  double depth_upper_mm = 0;  ///< proven: nowhere in the move is it more
  bool has_witness = false;   ///< depth > 0
  double t = 0;
  Vec3 point = Vec3::Zero();    ///< of the surface, part coordinates
  Vec3 normal = Vec3::UnitZ();  ///< in which the head must move away by the depth
  std::size_t target = 0;       ///< which of those queried
  std::uint32_t triangle = 0;   ///< of that tree
  std::uint64_t bounds = 0;
};

/// Searches best first (best_first_search.h) over (interval of time x part of the surface). Planes that all of the head
/// is below are queried first, the ones that bounded other parts. In the tool's frame a point of the surface stays
/// within `bulge` of the chord between its positions at both ends of an interval. The head's signed distance is
/// 1-Lipschitz. So over the interval and a ball about the point it is nowhere below half of (sum of both ends - path
/// length) - radius.
///
/// Requires resolution and gap > 0, and no negative reach.
/// Ensures  At any budget, depth <= true depth <= depth_upper.
/// Source   Space-time bounds, thesis 2.4.14; chord and bulge as in docs/method/certified_sweep.md.
[[nodiscard]] HeadResult search_head(const BodyMotion& motion, const HeadBody& head,
                                     std::span<const HeadTarget> targets, const SearchGoal& goal);

/// Does the same for the remainder in `start`: its seeds name a target and a triangle of its tree, and it has no value.
[[nodiscard]] HeadResult search_head(const BodyMotion& motion, const HeadBody& head,
                                     std::span<const HeadTarget> targets, const SearchGoal& goal,
                                     const SearchStart& start);

}  // namespace gouge
