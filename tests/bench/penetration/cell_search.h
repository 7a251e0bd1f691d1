#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/penetration/depth_body.h"
#include "lib/penetration/find_penetration.h"
#include "lib/penetration/point_body.h"
#include "lib/surface/surface.h"
#include "tests/bench/penetration/clearance.h"
#include "tests/bench/penetration/near_facets.h"

namespace gouge {

/// A solid with what its cells know: several seconds to make, then the fastest queries.
struct CellBody {
  explicit CellBody(const DepthBody& solid) : body(solid), near(solid), clearance(solid) {}

  const DepthBody& body;
  NearFacets near;
  Clearance clearance;
};

/// The exact mode through the standing body's cells: what most points cost is to look up their cell.
///
/// Descends the moving tree only, by balls: a ball farther from the solid than its radius is done. The
/// points of the leaves left over query the grid; those that may be inside measure the few facets of their
/// cell, or search the standing tree from the one nearest to it. Returns what the trees do (docs/method/
/// shallow_penetration.md, section 4).
class CellSearch {
 public:
  CellSearch(const CellBody& cells, const PointBody& points, const PenetrationOptions& options = {});

  /// The result stays valid until the next call, as that of PenetrationFinder.
  const PenetrationResult& find(const RigidTransform& pose);

 private:
  /// A point that may be inside.
  struct Asked {
    Vec3 place;
    std::uint32_t point;
    std::uint32_t cell;
  };

  void measure();
  void descend(const RigidTransform& pose);
  void look_up(const KdopNode& leaf, const RigidTransform& pose);
  void report(const Asked& asked, const ClosestPoint& foot);
  [[nodiscard]] ClosestPoint nearest(const Asked& asked);

  const CellBody& cells_;
  const DepthBody& body_;
  const PointBody& points_;
  PenetrationOptions options_;
  double rim_mm_;  ///< nearer to an edge than this counts as beyond it: some roundings of doubles
  /// By node: a ball about its points, centre and radius.
  std::vector<std::array<double, 4>> balls_;
  std::vector<double> xs_, ys_, zs_;  ///< the points in leaf order
  PenetrationResult result_;
  std::vector<std::uint32_t> stack_;
  std::vector<Asked> asked_;
  std::vector<ClosestPoint> feet_;       ///< of asked_
  std::vector<std::uint32_t> asked_of_;  ///< by point: slot in asked_, if its bit is set
  std::vector<std::uint64_t> is_asked_;  ///< a bit for each point
};

}  // namespace gouge
