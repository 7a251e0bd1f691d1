#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// The parts of a block tree. They are plain arrays, because this file is compiled for several instruction sets.

namespace gouge {

inline constexpr std::size_t kBlockLanes = 16;
using Lanes = std::array<float, kBlockLanes>;

/// The children of one node. Coordinates are mm in the tree's own frame: part coordinates minus `origin`. Every length
/// is rounded up far enough that the true surface is inside, in spite of single precision.
struct alignas(64) NodeBlock {
  std::array<Lanes, 3> center;
  std::array<Lanes, 3> normal;                   ///< approximately unit
  Lanes half_thickness_mm;                       ///< |normal . (x - center)| <= half_thickness
  Lanes disc_radius_mm;                          ///< maximum distance of x from the line through center along normal
  Lanes radius_mm;                               ///< |x - center| <= radius for every x below the child
  std::array<std::uint32_t, kBlockLanes> child;  ///< index into nodes or into leaves
  std::uint32_t count = 0;                       ///< number of lanes in use; the others repeat lane 0
  bool has_leaves = false;                       ///< the children are leaves
};

/// Triangles side by side: coordinate k of corner c of lane i is corner[c][k][i].
struct alignas(64) TriangleBlock {
  std::array<std::array<Lanes, 3>, 3> corner;
  std::array<std::uint32_t, kBlockLanes> triangle;  ///< index for BlockTree::corners
  std::uint32_t count = 0;                          ///< number of lanes in use; the others repeat lane 0
};

}  // namespace gouge
