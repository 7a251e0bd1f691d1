#pragma once

#include <span>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/check/prepared_scene.h"
#include "lib/head/head_body.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A path, what it was checked against, and the result. Everything pointed at must outlive it; a tool without variants
/// is left out.
struct CheckedToolpath {
  const Toolpath* toolpath = nullptr;
  const Scene* scene = nullptr;
  const PreparedScene* prepared = nullptr;  ///< the same scene with its indices
  std::vector<const ToolVariants*> tools;   ///< per tool index of the toolpath; may hold nullptr
  const CheckResult* result = nullptr;
  CheckOptions options;
  std::span<const HeadBody> heads;  ///< in the tool's frame; they move with every tool
};

}  // namespace gouge
