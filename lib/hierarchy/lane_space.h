#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lib/geom/half_space.h"
#include "lib/hierarchy/block_tree.h"

namespace gouge {

/// The intersection of half-spaces in the frame of a tree, tested for sixteen lanes at a time. It uses the processor's
/// instructions and gives the same result with any of them.
class LaneSpace {
 public:
  /// Prepares the test. Requires at most kMaxHalfSpaces.
  LaneSpace(const BlockTree& tree, std::span<const HalfSpace> space);

  /// Returns a bit for each lane of a node whose bound reaches into, or nearly into, each of the half-spaces.
  [[nodiscard]] std::uint32_t reached(const NodeBlock& node) const;
  /// Returns the same for the triangles of a leaf.
  [[nodiscard]] std::uint32_t reached(const TriangleBlock& leaf) const;

 private:
  struct Half {
    std::array<float, 3> direction{};
    float min_mm = 0;
  };
  [[nodiscard]] std::span<const Half> halves() const { return {halves_.data(), count_}; }
  static void find_reach(const NodeBlock& node, std::span<const Half> halves, Lanes& reach_mm);
  static void find_reach(const TriangleBlock& leaf, std::span<const Half> halves, Lanes& reach_mm);

  std::array<Half, kMaxHalfSpaces> halves_;
  std::size_t count_;
};

}  // namespace gouge
