#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lib/hierarchy/blocks.h"

// Lower bounds of the distance of a point from sixteen nodes or triangles, in single precision. The same source is
// compiled for several instruction sets. IEEE 754 rounds each of its operations correctly, and none is fused or
// reordered, so all instruction sets give the same bytes. Proof of the bounds: docs/method/closest_point.md.

namespace gouge {

/// A point in the frame of a tree, and the error bounds of its distances in any lane.
struct DistanceQuery {
  /// Bound on the rounding of a triangle's distance in single precision, relative to the distance of a corner from the
  /// point.
  static constexpr double kTriangleRounding = 1.0 / (1 << 20);

  std::array<float, 3> point{};  ///< mm, part coordinates minus the tree's origin
  float node_slack_mm = 0;       ///< rounding of the point, and of distances computed in double precision
  float triangle_slack_mm = 0;   ///< node_slack_mm, plus the rounding of stored corners and kTriangleRounding of the
                                 ///< farthest corner
};

struct DistanceKernel {
  const char* name;
  /// Writes for each lane a lower bound, at least 0, of the distance of its points. Lowers `within_mm` to a distance at
  /// which some lane has a point. Returns the lanes in use whose bound is at most that distance, lane i as bit i.
  std::uint32_t (*nodes)(const NodeBlock&, const DistanceQuery&, float& within_mm, Lanes& min_mm);
  std::uint32_t (*triangles)(const TriangleBlock&, const DistanceQuery&, float& within_mm, Lanes& min_mm);
};

/// Returns all kernels that this processor can run, the fastest last.
[[nodiscard]] std::span<const DistanceKernel* const> distance_kernels();
[[nodiscard]] const DistanceKernel& fastest_distance_kernel();

}  // namespace gouge
