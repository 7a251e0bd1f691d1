#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/penetration/depth_body.h"

namespace gouge {

/// Counters of the cost of a query, the same on every machine (thesis 5.4, tables 6.a to 6.c).
struct PenetrationCounters {
  std::uint64_t volume_pairs = 0;         ///< N_b: number of overlap tests of two volumes
  std::uint64_t primitive_pairs = 0;      ///< N_n: number of points tested against facets
  std::uint64_t exact_pairs = 0;          ///< of these, the number of computed distances
  std::uint64_t volumes_updated = 0;      ///< number of moving volumes updated to the pose
  std::uint64_t corners_transformed = 0;  ///< number of corner vertices of these volumes
  std::uint64_t volumes_shifted = 0;      ///< number of updated volumes whose intervals were only shifted
  std::uint64_t points_transformed = 0;
  std::uint64_t false_positives = 0;  ///< number of points within a facet's reach that are not inside
  std::uint64_t inside_tests = 0;     ///< number of searches that decided whether a point far from the surface is
                                      ///< inside
  std::uint32_t static_level = 0, moving_level = 0;  ///< deepest levels reached in both trees
};

struct NarrowResult {
  bool is_inside = false;  ///< true: inside and within the depth; false: outside, or deeper
  double depth_mm = 0;     ///< distance to the surface
  Vec3 normal = Vec3::UnitZ();
  std::uint32_t triangle = 0;  ///< index in body.mesh()
};

/// A test of the points of one leaf against the facets of the leaves that it met (thesis 5.2.2).
///
/// Finds the nearest of the given facets. With complete coverage these include every facet within the depth of the
/// point. So it is the nearest of all, and the side it gives is the true one: docs/method/shallow_penetration.md,
/// section 4. The filter is in single precision, the decision in double.
class NarrowPhase {
 public:
  explicit NarrowPhase(const DepthBody& body);

  /// Loads the facets of leaf nodes of the body's tree.
  void set_leaves(std::span<const std::uint32_t> leaves);
  [[nodiscard]] NarrowResult test(const Vec3& point_part, PenetrationCounters& counters);

 private:
  struct Hit {
    std::uint32_t slot;
    float least;  ///< lower bound of the facet's distance: the facet lies in its plane and in the ball of its disc
  };

  bool filter(const Vec3& point);
  [[nodiscard]] NarrowResult nearest(const Vec3& point, PenetrationCounters& counters) const;
  [[nodiscard]] NarrowResult judge(const Vec3& point, std::uint32_t slot, const TrianglePoint& nearest,
                                   PenetrationCounters& counters) const;

  const DepthBody& body_;
  float reach_;  ///< depth plus the rounding of single precision
  std::vector<std::uint32_t> slots_;
  std::vector<float> blocks_;  ///< facets in groups of four: nx ny nz o cx cy cz r
  std::vector<Hit> hits_;
};

/// Rim of a facet that does not count as its face. A point whose foot has a smaller barycentric coordinate is examined
/// as a point of the facet's edges.
inline constexpr double kFaceRim = Tolerance::kRounding;

/// Returns, by slot in the tree, 1 if no other facet crosses the prism of the body's depth below the facet. A point in
/// such a prism is inside, and no wall behind the facet is thinner than the depth. An uncertain crossing counts as a
/// crossing.
/// Cost     A search of the tree for each facet.
[[nodiscard]] std::vector<std::uint8_t> facets_clear_below(const DepthBody& body);

}  // namespace gouge
