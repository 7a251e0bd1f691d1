#pragma once

#include <cstdint>

#include "lib/penetration/depth_body.h"

namespace gouge {

enum class SafeDepthLimit {
  asked,     ///< safe to the requested depth
  collapse,  ///< a facet of the offset has shrunk to nothing: local curvature
  obstacle,  ///< another part of the surface comes within reach: feature size
};

struct SafeDepth {
  double depth_mm = 0;
  SafeDepthLimit limit = SafeDepthLimit::asked;
  std::uint32_t triangle = 0;  ///< of body.mesh(): where the limit is
};

/// The largest depth to which the surface can be offset before the offset meets itself, at most `asked_mm`:
/// the metric that thesis 6.3 leaves open.
///
/// The smaller of two: the depth at which a facet of the offset turns over, and the radius of the smallest
/// ball that touches a facet from within and reaches an opposed facet not its neighbour. The second is
/// bounded from below, by no more than a tenth. Below it facets' cells do not meet, so the bisector planes
/// (thesis 4.8) are the true borders of the Voronoi diagram. Derivation:
/// docs/method/shallow_penetration.md, section 3.
///
/// Cost  O(n log n) while the depth is small against the part; one thread.
[[nodiscard]] SafeDepth largest_safe_depth(const DepthBody& body, double asked_mm);

}  // namespace gouge
