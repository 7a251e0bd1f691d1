#pragma once

#include <span>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A path, the scene and tools with which it was checked, and the result. All objects that it points to must outlive
/// it. A tool without variants is left out.
struct CheckedToolpath {
  const Toolpath* toolpath = nullptr;
  const Scene* scene = nullptr;
  const PreparedScene* prepared = nullptr;  ///< the same scene with its indices
  std::vector<const ToolVariants*> tools;   ///< indexed like the tools of the toolpath; may contain nullptr
  const CheckResult* result = nullptr;
  CheckOptions options;
  std::span<const HeadBody> heads;  ///< in the frame of the tool; they move with every tool
};

}  // namespace gouge
