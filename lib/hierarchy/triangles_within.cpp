#include "lib/hierarchy/triangles_within.h"

#include <algorithm>
#include <array>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/hierarchy/lane_space.h"
#include "lib/hierarchy/traverse.h"

namespace gouge {
namespace {

/// Visits the leaves whose bounds reach into each half-space, until `VisitLeaf` returns true.
template <typename VisitLeaf>
struct LeavesWithin {
  const LaneSpace& space;
  const VisitLeaf& visit_leaf;

  [[nodiscard]] MaskedLanes children(const NodeBlock& node) const { return MaskedLanes(space.reached(node)); }
  [[nodiscard]] bool visit(const TriangleBlock& leaf) const { return visit_leaf(leaf); }
};

template <typename VisitLeaf>
bool visit_leaves(const BlockTree& tree, const LaneSpace& space, const VisitLeaf& visit_leaf) {
  LeavesWithin<VisitLeaf> leaves{space, visit_leaf};
  return traverse(tree, leaves);
}

}  // namespace

std::vector<std::uint32_t> triangles_within(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::vector<std::uint32_t> found;
  visit_leaves(tree, LaneSpace(tree, space), [&](const TriangleBlock& leaf) {
    found.insert(found.end(), leaf.triangle.begin(), leaf.triangle.begin() + leaf.count);
    return false;
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool is_entered(const BlockTree& tree, std::span<const HalfSpace> space) {
  std::array<HalfSpace, kMaxHalfSpaces> wider;
  const std::size_t count = std::min(space.size(), wider.size());
  for (std::size_t i = 0; i < count; ++i) wider[i] = {space[i].direction, space[i].min_mm - Tolerance::kRounding_mm};
  const LaneSpace lane_space(tree, space);
  return visit_leaves(tree, lane_space, [&](const TriangleBlock& leaf) {
    MaskedLanes lanes(lane_space.reached(leaf));
    while (const auto lane = lanes.next()) {
      if (is_any_within(tree.corners(leaf.triangle[*lane]), {wider.data(), count})) return true;
    }
    return false;
  });
}

double highest_along(const BlockTree& tree, const Vec3& direction, double low_mm, double high_mm) {
  const std::array<HalfSpace, 1> above{{{direction, low_mm}}};
  const LaneSpace space(tree, above);
  double highest = low_mm;
  const bool is_higher = visit_leaves(tree, space, [&](const TriangleBlock& leaf) {
    MaskedLanes lanes(space.reached(leaf));
    while (const auto lane = lanes.next()) {
      for (const Vec3& corner : tree.corners(leaf.triangle[*lane])) highest = std::max(highest, direction.dot(corner));
    }
    return highest > high_mm;
  });
  return is_higher ? std::numeric_limits<double>::infinity() : highest;
}

}  // namespace gouge
