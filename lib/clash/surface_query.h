#pragma once

#include <optional>

#include "lib/penetration/depth_body.h"

namespace gouge {

/// The part of a ball on one side of a plane: |x - centre| <= radius and direction . (x - centre) >= from.
struct BallCap {
  Vec3 centre = Vec3::Zero();
  double radius_mm = 0;
  Vec3 direction = Vec3::UnitZ();  ///< unit
  double from_mm = 0;
};

struct CapHit {
  std::uint32_t slot = 0;     ///< of the facet, in body.tree.order
  Vec3 point = Vec3::Zero();  ///< of it, in the cap, the nearest to the cap's centre
};

/// A facet that reaches into the cap and for which `is_allowed(slot)` is false; nothing when there is none.
/// Ensures  no facet that reaches into the cap by more than rounding is missed; always the same one.
template <typename IsAllowed>
[[nodiscard]] std::optional<CapHit> find_in_cap(const DepthBody& body, const BallCap& cap, const IsAllowed& is_allowed);

namespace detail {

/// Whether a node's box reaches into the cap.
[[nodiscard]] bool may_reach(const float* box, const BallCap& cap);

/// The nearest point to the cap's centre of the part of a facet that is in the cap.
[[nodiscard]] std::optional<Vec3> nearest_in_cap(const std::array<Vec3, 3>& facet, const BallCap& cap);

}  // namespace detail

template <typename IsAllowed>
std::optional<CapHit> find_in_cap(const DepthBody& body, const BallCap& cap, const IsAllowed& is_allowed) {
  std::vector<std::uint32_t> open(body.tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    if (!detail::may_reach(body.boxes.data() + 6 * std::size_t{index}, cap)) continue;
    const KdopNode& node = body.tree.nodes[index];
    for (std::uint32_t k = 0; k < node.children; ++k) open.push_back(node.first + k);
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      const std::uint32_t slot = node.first + k;
      const std::optional<Vec3> point = detail::nearest_in_cap(body.corners[slot], cap);
      if (point && !is_allowed(slot)) return CapHit{slot, *point};
    }
  }
  return std::nullopt;
}

}  // namespace gouge
