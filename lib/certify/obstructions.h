#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "lib/geom/vec.h"

namespace gouge {

struct CheckSetup;

/// The highest point of meshes and stock in a direction.
struct Top {
  double height_mm = -std::numeric_limits<double>::infinity();  ///< with the clearance
  bool has_clearance = false;
};

/// The boxes of all that is in the way of a tool: parts, fixtures and stock.
class Obstructions {
 public:
  explicit Obstructions(const CheckSetup& setup);

  [[nodiscard]] Top top_along(const Vec3& direction) const;

 private:
  std::vector<std::pair<Box3, double>> boxes_;  // with the clearance of the mesh
};

/// Returns the lowest point of all tools and heads along the tool axis, from the tip, at most 0. Stock to leave, clearances
/// and tolerances of the motion are in the forms of the tools.
[[nodiscard]] double lowest_point_mm(const CheckSetup& setup);

}  // namespace gouge
