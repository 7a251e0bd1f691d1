#include "lib/hierarchy/lane_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/instruction_sets.h"
#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr float kNormal = 1e-6F;  // the length of a node's stored normal differs from 1 by less than this

// Loops over sixteen numbers, which the compiler adapts to the width of the processor. It would split vectors of
// sixteen on a narrower processor into single numbers wherever they are compared.

/// Lowers `least` to `reach` in each lane. Returns whether any lane is then at least 0.
[[gnu::always_inline]] inline bool lower(const Lanes& reach, Lanes& least) {
  std::int32_t open = 0;
  for (std::size_t i = 0; i < kBlockLanes; ++i) {
    least[i] = reach[i] < least[i] ? reach[i] : least[i];
    open |= least[i] >= 0 ? 1 : 0;
  }
  return open != 0;
}

std::uint32_t not_negative(const Lanes& reach_mm, std::uint32_t count) {
  std::uint32_t found = 0;
  for (std::uint32_t lane = 0; lane < count; ++lane) found |= reach_mm[lane] >= 0 ? 1U << lane : 0U;
  return found;
}

}  // namespace

LaneSpace::LaneSpace(const BlockTree& tree, std::span<const HalfSpace> space)
    : count_(std::min(space.size(), halves_.size())) {
  for (std::size_t i = 0; i < count_; ++i) {
    const double min_mm = space[i].min_mm - space[i].direction.dot(tree.origin);
    // The slack covers rounding to single precision: of the sums here, relative to coordinates in the tree's frame, and
    // of the stored corners.
    const double slack_mm = Tolerance::kSingleSum * (tree.radius_mm + std::abs(min_mm)) + Tolerance::kRounding_mm;
    for (std::size_t k = 0; k < 3; ++k)
      halves_[i].direction[k] = static_cast<float>(space[i].direction[static_cast<Eigen::Index>(k)]);
    halves_[i].min_mm = static_cast<float>(min_mm - slack_mm);
  }
}

std::uint32_t LaneSpace::reached(const NodeBlock& node) const {
  Lanes reach_mm;
  find_reach(node, halves(), reach_mm);
  return not_negative(reach_mm, node.count);
}

std::uint32_t LaneSpace::reached(const TriangleBlock& leaf) const {
  Lanes reach_mm;
  find_reach(leaf, halves(), reach_mm);
  return not_negative(reach_mm, leaf.count);
}

// Finds how far each lane reaches into the half-space that it reaches least. The reach is that of the ball or, if
// smaller, of the disc. If no lane reaches into one half-space, the others are not tested.
GOUGE_WIDE void LaneSpace::find_reach(const NodeBlock& node, std::span<const Half> halves, Lanes& least) {
  least.fill(std::numeric_limits<float>::max());
  Lanes reach;
  for (const Half& half : halves) {
    const float dx = half.direction[0], dy = half.direction[1], dz = half.direction[2], min_mm = half.min_mm;
    for (std::size_t i = 0; i < kBlockLanes; ++i) {
      const float turn = dx * node.normal[0][i] + dy * node.normal[1][i] + dz * node.normal[2][i];
      const float cosine = std::abs(turn), across = 1 - cosine * cosine + kNormal;
      const float sine = std::sqrt(across > 0 ? across : 0);
      const float thick = node.half_thickness_mm[i], disc = node.disc_radius_mm[i], ball = node.radius_mm[i];
      const float extent = cosine * thick + sine * disc + kNormal * (thick + disc);
      const float at = dx * node.center[0][i] + dy * node.center[1][i] + dz * node.center[2][i] - min_mm;
      reach[i] = at + (extent < ball ? extent : ball);
    }
    if (!lower(reach, least)) return;
  }
}

// Finds the highest corner of each triangle in the half-space that it reaches least.
GOUGE_WIDE void LaneSpace::find_reach(const TriangleBlock& leaf, std::span<const Half> halves, Lanes& least) {
  least.fill(std::numeric_limits<float>::max());
  Lanes reach;
  for (const Half& half : halves) {
    const float dx = half.direction[0], dy = half.direction[1], dz = half.direction[2], min_mm = half.min_mm;
    for (std::size_t i = 0; i < kBlockLanes; ++i) {
      const float a = dx * leaf.corner[0][0][i] + dy * leaf.corner[0][1][i] + dz * leaf.corner[0][2][i];
      const float b = dx * leaf.corner[1][0][i] + dy * leaf.corner[1][1][i] + dz * leaf.corner[1][2][i];
      const float c = dx * leaf.corner[2][0][i] + dy * leaf.corner[2][1][i] + dz * leaf.corner[2][2][i];
      const float high = a < b ? b : a;
      reach[i] = (high < c ? c : high) - min_mm;
    }
    if (!lower(reach, least)) return;
  }
}

}  // namespace gouge
