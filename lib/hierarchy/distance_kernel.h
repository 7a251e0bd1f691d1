#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lib/hierarchy/blocks.h"

// Bounds the distance of a point to sixteen nodes or triangles from below, in single precision. The same source is
// compiled for several instruction sets. Every operation is one that IEEE 754 rounds correctly, and none is fused or
// reordered, so all of them give the same bytes. Proof of the bounds: docs/method/closest_point.md.

namespace gouge {

/// A point in the frame of a tree, and how far what is computed for it may be off whatever the lane.
struct DistanceQuery {
  /// Bound on the rounding of a triangle's distance in single precision, relative to a corner's distance from the
  /// point.
  static constexpr double kTriangleRounding = 1.0 / (1 << 20);

  std::array<float, 3> point{};  ///< mm, part coordinates minus the tree's origin
  float node_slack_mm = 0;       ///< rounding of the point, and of distances computed in double precision
  float triangle_slack_mm = 0;   ///< the same, that of stored corners, and kTriangleRounding of the farthest of them
};

struct DistanceKernel {
  const char* name;
  /// Writes by lane a bound, at least 0, that no point of the lane is nearer than. Lowers `within_mm` to where some
  /// lane's nearest point is. Returns the lanes in use whose bound is at most that, lane i as bit i.
  std::uint32_t (*nodes)(const NodeBlock&, const DistanceQuery&, float& within_mm, Lanes& min_mm);
  std::uint32_t (*triangles)(const TriangleBlock&, const DistanceQuery&, float& within_mm, Lanes& min_mm);
};

/// Returns all that this processor can run, the fastest last.
[[nodiscard]] std::span<const DistanceKernel* const> distance_kernels();
[[nodiscard]] const DistanceKernel& fastest_distance_kernel();

}  // namespace gouge
