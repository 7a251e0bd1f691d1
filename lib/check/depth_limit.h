#pragma once

#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"

namespace gouge {

/// How deep a surface may be in a tool without that the tool reaches farther into the solid than kReachPerDepth times
/// tolerance + resolution.
[[nodiscard]] inline SureDepth sure_depth(const ToolVariants& tool, const PreparedScene& scene,
                                          const CheckOptions& options) {
  std::vector<ToolVariants::SureForm> forms;
  for (const PreparedObstacle& obstacle : scene.obstacles()) {
    if (!obstacle.meshes.empty()) forms.push_back({&(tool.*obstacle.rule.form), &(tool.*obstacle.rule.sure_depths)});
  }
  return tool.sure_depth(forms, options.tolerance_mm + options.resolution_mm);
}

}  // namespace gouge
