#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/units.h"
#include "lib/check/scene.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/path/toolpath.h"

// Where a scene lies to a path and how large it is beside it, by boxes.

namespace gouge {

/// Bounds the distance of any point of the scene from any tip of the path, also between positions. The bound is the
/// diagonal of the box of meshes and tips. 0 when there is nothing.
[[nodiscard]] double reach_mm(const Toolpath& path, const Scene& scene);

/// All parts together beside a path.
struct PartsBesidePath {
  double gap_mm = 0;         ///< between the box of the parts and one that holds every tip
  double times_smaller = 1;  ///< the parts than what is cut, rapids left out; 1 where nothing is cut

  // Parts are about as large as what is milled of them.
  static constexpr double kFarOff = 8;
  [[nodiscard]] bool is_far_smaller() const { return times_smaller > kFarOff; }
  [[nodiscard]] bool is_far_larger() const { return times_smaller < 1 / kFarOff; }
};

/// Returns nothing where there is no part or no motion.
[[nodiscard]] std::optional<PartsBesidePath> compare_parts(const Toolpath& path, const Scene& scene);

/// Returns the units, the best first, that would make parts about as large as the path. The parts are that many times
/// smaller when read in `stl_unit`.
[[nodiscard]] std::vector<const UnitFacts*> units_that_fit(double times_smaller, LengthUnit stl_unit);

/// Returns the error for a mesh with a vertex that is beyond kFarthest_mm (reach.h) or is not a number; else nothing.
/// The words `body`, such as "part", and `advice`, on what to examine, are part of the message. Code: mesh-too-far.
[[nodiscard]] std::optional<Diagnostic> find_too_far(const IndexedMesh& mesh, const std::string& body,
                                                     const std::string& advice);

}  // namespace gouge
