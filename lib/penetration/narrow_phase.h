#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/penetration/depth_body.h"

namespace gouge {

/// Cost of a query, in numbers that are the same on every machine (thesis 5.4, tables 6.a to 6.c).
struct PenetrationCounters {
  std::uint64_t volume_pairs = 0;         ///< N_b: overlap tests of two volumes
  std::uint64_t primitive_pairs = 0;      ///< N_n: points tested against facets
  std::uint64_t exact_pairs = 0;          ///< of them, those whose distance was computed
  std::uint64_t volumes_updated = 0;      ///< moving volumes brought to the pose
  std::uint64_t corners_transformed = 0;  ///< corner vertices of these volumes
  std::uint64_t volumes_shifted = 0;      ///< of the updated volumes, those whose intervals were only shifted
  std::uint64_t points_transformed = 0;
  std::uint64_t false_positives = 0;  ///< points within a facet's reach that are not inside
  std::uint64_t inside_tests = 0;     ///< searches that decided whether something far from the surface is inside
  std::uint32_t static_level = 0, moving_level = 0;  ///< deepest levels of both trees reached
};

struct NarrowResult {
  bool is_inside = false;  ///< and within the depth; else it is outside, or deeper
  double depth_mm = 0;     ///< to the surface
  Vec3 normal = Vec3::UnitZ();
  std::uint32_t triangle = 0;  ///< of body.mesh()
};

/// Points of one leaf against the facets of the leaves it met (thesis 5.2.2).
///
/// Finds the nearest facet among those given. With complete coverage they hold every facet within the depth of the
/// point. So it is the nearest of all and the side it gives is the true one: docs/method/shallow_penetration.md,
/// section 4. Filters in single precision, decides in double.
class NarrowPhase {
 public:
  explicit NarrowPhase(const DepthBody& body);

  /// Takes the facets of leaf nodes of the body's tree.
  void set_leaves(std::span<const std::uint32_t> leaves);
  [[nodiscard]] NarrowResult test(const Vec3& point_part, PenetrationCounters& counters);

 private:
  struct Hit {
    std::uint32_t slot;
    float least;  ///< the facet is not nearer than this: it lies in its plane and in its disc's ball
  };

  bool filter(const Vec3& point);
  [[nodiscard]] NarrowResult nearest(const Vec3& point, PenetrationCounters& counters) const;
  [[nodiscard]] NarrowResult judge(const Vec3& point, std::uint32_t slot, const TrianglePoint& nearest,
                                   PenetrationCounters& counters) const;

  const DepthBody& body_;
  float reach_;  ///< depth with what single precision may be off
  std::vector<std::uint32_t> slots_;
  std::vector<float> blocks_;  ///< facets, four by four: nx ny nz o cx cy cz r
  std::vector<Hit> hits_;
};

/// The rim of a facet that does not count as its face. Points whose foot has a smaller barycentric coordinate are
/// examined as points of its edges.
inline constexpr double kFaceRim = Tolerance::kRounding;

/// Returns by slot in the tree 1 when no other facet crosses the prism of the body's depth below the facet. A point in
/// such a prism is inside, and no wall behind the facet is thinner than the depth. Uncertainty counts as crossing.
/// Cost     A search of the tree for each facet.
[[nodiscard]] std::vector<std::uint8_t> facets_clear_below(const DepthBody& body);

}  // namespace gouge
