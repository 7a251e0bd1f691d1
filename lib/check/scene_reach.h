#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/units.h"
#include "lib/check/scene.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/path/toolpath.h"

// Functions that compare the position and size of a scene with those of a path, by boxes.

namespace gouge {

/// Returns an upper bound of the distance of any point of the scene from any tip of the path, also between positions.
/// The bound is the diagonal of the box of meshes and tips. Returns 0 if there are neither meshes nor tips.
[[nodiscard]] double reach_mm(const Toolpath& path, const Scene& scene);

/// Position and size of all parts together, relative to a path.
struct PartsBesidePath {
  double gap_mm = 0;         ///< distance of the box of the parts from a box of all tips
  double times_smaller = 1;  ///< size of the cut region, without rapids, divided by the size of the parts; 1 if nothing
                             ///< is cut

  // Ratio from which on the sizes do not match: a part is about as large as the region that is milled.
  static constexpr double kFarOff = 8;
  [[nodiscard]] bool is_far_smaller() const { return times_smaller > kFarOff; }
  [[nodiscard]] bool is_far_larger() const { return times_smaller < 1 / kFarOff; }
};

/// Compares the parts with a path. Returns nothing if there is no part or no motion.
[[nodiscard]] std::optional<PartsBesidePath> compare_parts(const Toolpath& path, const Scene& scene);

/// Returns the units with which the parts would be about as large as the path, the best first. `times_smaller` is the
/// ratio that results with `stl_unit`.
[[nodiscard]] std::vector<const UnitFacts*> units_that_fit(double times_smaller, LengthUnit stl_unit);

/// Returns the units with which the region that the path cuts would lie in the box of the parts, or out of it by a tenth of
/// its size at most, and the parts would not be larger than the region by more than a factor of 20. Requires parts at the
/// coordinates of their files.
[[nodiscard]] std::vector<const UnitFacts*> units_in_place(const Toolpath& path, const Scene& scene,
                                                           LengthUnit stl_unit);

/// Returns the error for a mesh with a vertex that is beyond kFarthest_mm (reach.h) or is not a number; otherwise
/// nothing. The message contains `body`, such as "part", and `advice`, which states the object to examine. Code:
/// mesh-too-far.
[[nodiscard]] std::optional<Diagnostic> find_too_far(const IndexedMesh& mesh, const std::string& body,
                                                     const std::string& advice);

}  // namespace gouge
