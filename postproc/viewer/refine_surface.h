#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "lib/geom/vec.h"
#include "postproc/viewer/surface_values.h"
#include "postproc/viewer/viewer_mesh.h"

namespace gouge {

/// Quantities to sample on a surface; `values` must outlive it.
struct AskedValues {
  const SurfaceValues* values;
  SurfaceQuantity quantity = SurfaceQuantity::pictured;
};

/// Those values at the vertices of a surface: one list for each of `asked`, as long as the vertices.
using VertexValues = std::vector<std::vector<float>>;

/// Cuts the triangles of `mesh` where one of `asked` is more than 0, as finely as a picture needs. Returns each of
/// these values at all vertices, mm. A gouge in the middle of one large triangle touches no vertex of it.
///
/// The `points` are places where the surface is known to be gouged, besides the points that are examined. The `size_mm`
/// is across the parts.
/// Ensures  An edge is cut by its own position alone, so that neighbours agree and no gap opens. The same on every run.
/// Cost     About 60,000 points examined, and 150,000 triangles more at most.
[[nodiscard]] VertexValues refine_surface(ViewerMesh& mesh, const std::vector<AskedValues>& asked,
                                          const std::vector<Vec3>& points, double size_mm);

/// Places of space near a set of points, in cells that double in size from level to level.
class GougedCells {
 public:
  explicit GougedCells(double finest_mm) : finest_mm_(finest_mm), levels_(kLevels) {}

  void add(const Vec3& point);

  /// Returns true where a point lies within `reach_mm` of `at`, and for some up to four times as far away.
  [[nodiscard]] bool is_near(const Vec3& at, double reach_mm) const;

 private:
  static constexpr std::size_t kLevels = 20;

  double finest_mm_;
  std::vector<std::unordered_set<std::uint64_t>> levels_;
};

}  // namespace gouge
