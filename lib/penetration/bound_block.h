#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// A tree whose nodes are the bounds of eight groups of facets, or of single ones, side by side, and how far a
// point is from them at least. The same source is compiled for several instruction sets; every operation is
// one that IEEE 754 rounds correctly, none is fused or reordered, so all of them give the same bytes.

namespace gouge {

/// What each lane's facets lie in: a box; and a ball about `centre` of `radius`, cut by the slab of thickness
/// 2 `half` about normal . x = offset. Where the surface is nearly flat the slab is thin, which no box is
/// that stands askew. Single precision, widened when made.
struct alignas(64) BoundBlock {
  static constexpr std::size_t kLanes = 8;
  float low[3][kLanes], high[3][kLanes];
  float normal[3][kLanes], offset[kLanes], centre[3][kLanes], radius[kLanes], half[kLanes];
  std::uint32_t below[kLanes];  ///< the block of the lane's facets; with kIsFacet, the only one, by slot
  static constexpr std::uint32_t kIsFacet = 1U << 31;
};
static_assert(sizeof(BoundBlock) == 512);

struct BoundKernel {
  const char* name;
  /// By lane: not above the distance of the point to the lane's facets, less `slack_mm` and not below 0.
  void (*least_mm)(const BoundBlock& block, const float* point, float slack_mm, float* least_mm);
};

/// All that this processor can run, the fastest last.
[[nodiscard]] std::span<const BoundKernel* const> bound_kernels();
[[nodiscard]] const BoundKernel& fastest_bound_kernel();

}  // namespace gouge
