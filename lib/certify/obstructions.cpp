#include "lib/certify/obstructions.h"

#include <algorithm>
#include <cstddef>

#include "lib/certify/check.h"
#include "lib/check/contact_rule.h"

namespace gouge {

Obstructions::Obstructions(const CheckSetup& setup) {
  const std::vector<double> clearances = clearance_of_meshes(*setup.scene.scene);
  std::size_t mesh = 0;
  for (const PreparedObstacle& obstacle : setup.scene.obstacles()) {
    for (std::size_t k = 0; k < obstacle.meshes.size(); ++k)
      boxes_.emplace_back(box_of(obstacle.meshes.subspan(k, 1)), clearances.at(mesh++));
  }
  if (setup.stock != nullptr) boxes_.emplace_back(Box3(setup.stock->solid.low(), setup.stock->solid.high()), 0);
}

Top Obstructions::top_along(const Vec3& direction) const {
  Top top;
  for (const auto& [box, clearance_mm] : boxes_) {
    const double height_mm = highest_along(direction, box) + clearance_mm;
    if (height_mm > top.height_mm) top = {height_mm, clearance_mm > 0};
  }
  return top;
}

double lowest_point_mm(const CheckSetup& setup) {
  double lowest_mm = 0;
  for (const ToolVariants* tool : setup.tools) {
    if (tool == nullptr) continue;
    for (const CompiledTool* form : {&tool->against_part, &tool->against_fixture, &tool->with_clearance})
      if (!form->elements.empty()) lowest_mm = std::min(lowest_mm, form->z_min_mm);
  }
  for (const HeadBody& head : setup.heads) lowest_mm = std::min(lowest_mm, head.box.min().z());
  return lowest_mm;
}

}  // namespace gouge
