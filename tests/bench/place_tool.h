#pragma once

#include <cstdint>
#include <vector>

#include "tests/bench/bench_plan.h"
#include "tests/bench/exact_distance.h"

// The path of a tool over a mesh: every position is pushed along the surface's normal until the tool is
// 0.005 mm clear of that very mesh, then lifted or dipped as the plan states.

namespace gouge::bench {

inline constexpr double kClearance_mm = 0.005;
inline constexpr double kTruthAccuracy_mm = 1e-6;
inline constexpr double kFar_mm = 5;  ///< distances are not reported beyond this

/// A position with the truth about it: signed distances of the mesh from the two pieces of the tool.
struct PlacedPose {
  Pose pose;
  double lower_mm = 0, holder_mm = 0;  ///< exact to kTruthAccuracy_mm; kFar_mm when farther
  double is_air = 0;                   ///< 1: in an air pass
};

/// `density` positions for each of the plan's: the same curve, finer. Deterministic at any thread count.
[[nodiscard]] std::vector<PlacedPose> place_tool(const PartPlan& plan, const BenchTool& tool, const ExactDistance& mesh,
                                                 std::size_t density, unsigned threads);

}  // namespace gouge::bench
