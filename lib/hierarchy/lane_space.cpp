#include "lib/hierarchy/lane_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/instruction_sets.h"

namespace gouge {
namespace {

constexpr double kLaneRounding_mm = 1e-9;  // of coordinates up to 100 m and a few additions
// More than single precision is off in what is added up here, relative to coordinates in the tree's frame, and in where
// corners are stored.
constexpr double kLaneSingle = 1e-6;
constexpr float kNormal = 1e-6F;  // the stored normal of a node is longer or shorter than 1 by less

using V = float __attribute__((vector_size(64)));

[[gnu::always_inline]] inline V load(const Lanes& from) {
  V to;
  __builtin_memcpy(&to, from.data(), sizeof to);
  return to;
}

[[gnu::always_inline]] inline void store(const V& from, Lanes& to) { __builtin_memcpy(to.data(), &from, sizeof from); }

std::uint32_t not_negative(const Lanes& reach_mm, std::uint32_t count) {
  std::uint32_t found = 0;
  for (std::uint32_t lane = 0; lane < count; ++lane) found |= reach_mm[lane] >= 0 ? 1U << lane : 0U;
  return found;
}

}  // namespace

LaneSpace::LaneSpace(const BlockTree& tree, std::span<const HalfSpace> space)
    : count_(std::min(space.size(), halves_.size())) {
  for (std::size_t i = 0; i < count_; ++i) {
    const double least_mm = space[i].least_mm - space[i].direction.dot(tree.origin);
    const double slack_mm = kLaneSingle * (tree.radius_mm + std::abs(least_mm)) + kLaneRounding_mm;
    for (std::size_t k = 0; k < 3; ++k)
      halves_[i].direction[k] = static_cast<float>(space[i].direction[static_cast<Eigen::Index>(k)]);
    halves_[i].least_mm = static_cast<float>(least_mm - slack_mm);
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

// How far each lane reaches into the half-space that it reaches into least: its ball, or its disc where that is less.
GOUGE_WIDE void LaneSpace::find_reach(const NodeBlock& node, std::span<const Half> halves, Lanes& reach_mm) {
  const V x = load(node.center[0]), y = load(node.center[1]), z = load(node.center[2]);
  const V nx = load(node.normal[0]), ny = load(node.normal[1]), nz = load(node.normal[2]);
  const V thick = load(node.half_thickness_mm), disc = load(node.disc_radius_mm), ball = load(node.radius_mm);
  V least = V{} + std::numeric_limits<float>::max();
  for (const Half& half : halves) {
    const auto [dx, dy, dz] = half.direction;
    const V turn = dx * nx + dy * ny + dz * nz;
    const V cosine = turn < 0 ? -turn : turn;
    V sine = 1 - cosine * cosine + kNormal;
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) sine[lane] = sine[lane] > 0 ? std::sqrt(sine[lane]) : 0;
    const V extent = cosine * thick + sine * disc + kNormal * (thick + disc);
    const V reach = dx * x + dy * y + dz * z - half.least_mm + (extent < ball ? extent : ball);
    least = reach < least ? reach : least;
  }
  store(least, reach_mm);
}

// The highest corner of each triangle in the half-space that it reaches into least.
GOUGE_WIDE void LaneSpace::find_reach(const TriangleBlock& leaf, std::span<const Half> halves, Lanes& reach_mm) {
  V least = V{} + std::numeric_limits<float>::max();
  for (const Half& half : halves) {
    const auto [dx, dy, dz] = half.direction;
    V reach = V{} - std::numeric_limits<float>::max();
    for (std::size_t c = 0; c < 3; ++c) {
      const V high = dx * load(leaf.corner[c][0]) + dy * load(leaf.corner[c][1]) + dz * load(leaf.corner[c][2]);
      reach = high > reach ? high : reach;
    }
    reach -= half.least_mm;
    least = reach < least ? reach : least;
  }
  store(least, reach_mm);
}

}  // namespace gouge
