#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/geom/rigid_transform.h"
#include "lib/penetration/depth_body.h"
#include "lib/penetration/find_penetration.h"
#include "lib/penetration/nearest_foot.h"
#include "lib/penetration/point_body.h"

namespace gouge {

/// The exact mode through the standing body's cells: what most points cost is to look up their cell.
///
/// Descends the moving tree only, by balls: a ball farther from the solid than its radius is done. The
/// points of the leaves left over ask the grid; those that may be inside measure the few facets of their
/// cell, or search the standing tree from the one nearest to it. Answers as the trees do (docs/algorithms/
/// shallow_penetration.md, section 4).
class CellSearch {
 public:
  CellSearch(const DepthBody& body, const PointBody& points, const PenetrationOptions& options);

  /// Fills an empty answer.
  void find(const RigidTransform& pose, PenetrationAnswer& answer);

 private:
  /// A point that may be inside.
  struct Asked {
    Vec3 place;
    std::uint32_t point;
    std::uint32_t cell;
  };

  void descend(const RigidTransform& pose, PenetrationCounters& counters);
  void look_up(const KdopNode& leaf, const RigidTransform& pose);
  void tell(const Asked& asked, const SurfaceFoot& foot, PenetrationAnswer& answer) const;
  [[nodiscard]] SurfaceFoot nearest(const Asked& asked, PenetrationCounters& counters) const;

  const DepthBody& body_;
  const PointBody& points_;
  PenetrationOptions options_;
  double rim_mm_;  ///< nearer to an edge than this counts as beyond it: some roundings of doubles
  std::vector<std::uint32_t> stack_;
  std::vector<Asked> asked_;
  std::vector<SurfaceFoot> feet_;        ///< of asked_
  std::vector<std::uint32_t> asked_of_;  ///< by point: place in asked_, if its bit is set
  std::vector<std::uint64_t> is_asked_;  ///< a bit for each point
};

}  // namespace gouge
