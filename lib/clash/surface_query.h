#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/hierarchy/lane_bound.h"
#include "lib/surface/surface.h"

namespace gouge {

/// The part of a ball on one side of a plane: |x - centre| <= radius and direction . (x - centre) >= from.
struct BallCap {
  Vec3 centre = Vec3::Zero();
  double radius_mm = 0;
  Vec3 direction = Vec3::UnitZ();  ///< unit
  double from_mm = 0;
};

struct CapHit {
  std::uint32_t triangle = 0;
  Vec3 point = Vec3::Zero();  ///< the point of the facet in the cap that is nearest to the cap's centre
};

/// Returns a facet that reaches into the cap and for which `is_allowed(triangle)` is false; nothing if there is none.
/// Ensures  Each facet that reaches into the cap by more than rounding is examined. The result is always the same
///          facet.
template <typename IsAllowed>
[[nodiscard]] std::optional<CapHit> find_in_cap(const Surface& surface, const BallCap& cap,
                                                const IsAllowed& is_allowed);

namespace detail {

/// Returns whether the content of a bounding volume may reach into the cap.
[[nodiscard]] bool may_reach(const LaneBound& bound, const BallCap& cap);

/// Returns the point of a facet that is in the cap and nearest to the cap's centre; nothing if no point is in the cap.
[[nodiscard]] std::optional<Vec3> nearest_in_cap(const std::array<Vec3, 3>& facet, const BallCap& cap);

}  // namespace detail

template <typename IsAllowed>
std::optional<CapHit> find_in_cap(const Surface& surface, const BallCap& cap, const IsAllowed& is_allowed) {
  const BlockTree& tree = surface.tree();
  std::vector<std::uint32_t> open(tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const NodeBlock& node = tree.nodes[open.back()];
    open.pop_back();
    for (std::size_t lane = 0; lane < node.count; ++lane) {
      if (!detail::may_reach(LaneBound(tree, node, lane), cap)) continue;
      if (!node.has_leaves) {
        open.push_back(node.child[lane]);
        continue;
      }
      const TriangleBlock& leaf = tree.leaves[node.child[lane]];
      for (std::size_t k = 0; k < leaf.count; ++k) {
        const std::optional<Vec3> point = detail::nearest_in_cap(surface.corners(leaf.triangle[k]), cap);
        if (point && !is_allowed(leaf.triangle[k])) return CapHit{leaf.triangle[k], *point};
      }
    }
  }
  return std::nullopt;
}

}  // namespace gouge
