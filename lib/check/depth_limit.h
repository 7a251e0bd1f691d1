#pragma once

#include "lib/check/check_options.h"
#include "lib/check/scene.h"

namespace gouge {

/// How deep a surface may be in a tool without that the tool reaches farther into the solid than kReachPerDepth times
/// tolerance + resolution.
[[nodiscard]] inline SureDepth sure_depth(const ToolVariants& tool, const Scene& scene, const CheckOptions& options) {
  return tool.sure_depth(!scene.parts.empty(), !scene.fixtures.empty(), options.tolerance_mm + options.resolution_mm);
}

}  // namespace gouge
