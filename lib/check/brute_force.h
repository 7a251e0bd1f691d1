#pragma once

#include <array>

#include "lib/check/check_options.h"
#include "lib/check/motion.h"
#include "lib/check/scene.h"

// The slow, obvious reference: every triangle, many instants, no tree, no planes, only that the signed
// distance changes by no more than the distance moved.

namespace gouge {

/// Largest depth over a triangle at one pose, found to `accuracy_mm` from below.
[[nodiscard]] double triangle_depth(const CompiledTool& tool, const Pose& pose, const std::array<Vec3, 3>& triangle,
                                    double accuracy_mm);

struct BruteForceDepth {
  double depth_mm = 0;  ///< a lower bound of the true depth, nearer with more steps
  double t = 0;
};

/// Largest depth of the move at `steps` + 1 evenly spread instants, against parts and fixtures.
[[nodiscard]] BruteForceDepth brute_force_depth(const Motion& motion, const ToolVariants& tool, const Scene& scene,
                                                std::size_t steps, double accuracy_mm);

}  // namespace gouge
