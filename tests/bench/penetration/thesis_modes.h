#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lib/penetration/depth_body.h"

namespace gouge {

/// How the thesis decides which facet a point belongs to.
enum class ThesisMode {
  planes,   ///< 4.8: behind the facet and within its three bisector planes
  volumes,  ///< 4.7: behind the facet and within its leaf's volume
};

/// Bisector planes of a facet with its neighbours, edge k from corner k to the next: a point behind the facet
/// is nearer to the facet's plane than to the neighbour's while normal_k . (x - corner_k) >= 0.
using BisectorNormals = std::array<Vec3, 3>;

/// The narrow phases of thesis 4.7 and 4.8, which see nothing of what lies behind a facet: for comparison.
class ThesisModes {
 public:
  /// The body must outlive it; its volumes should be those of the thesis, Coverage::offset.
  explicit ThesisModes(const DepthBody& body);

  /// The least depth below the plane of a facet that the point belongs to, no more than the body's; nothing
  /// where there is none.
  /// Cost     O(facets).
  [[nodiscard]] std::optional<double> depth_mm(const Vec3& point, ThesisMode mode) const;

  /// By place in the body's tree.
  [[nodiscard]] const BisectorNormals& bisectors(std::size_t place) const { return bisectors_[place]; }

 private:
  [[nodiscard]] bool is_within_bisectors(const Vec3& point, std::size_t place) const;

  const DepthBody& body_;
  std::vector<BisectorNormals> bisectors_;
  std::vector<std::uint32_t> leaves_;  ///< by place
};

}  // namespace gouge
