#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/verify/claims.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"

// Depths at one point and instant, by the definition alone: the pose of the file, every piece of the contour,
// every facet of a head.

namespace gouge {

/// The contours of a tool that a claim may be about.
struct ClaimedTool {
  explicit ClaimedTool(const ToolVariants& tool)
      : bare(tool.bare),
        part(tool.against_part),
        fixture(tool.against_fixture),
        clearance(tool.with_clearance),
        non_cutting(tool.non_cutting) {}
  ToolContour bare, part, fixture, clearance, non_cutting;
};
using ClaimedTools = std::vector<std::unique_ptr<ClaimedTool>>;  ///< by Toolpath::tools; null: not defined
[[nodiscard]] ClaimedTools claimed_tools(const ClaimedScene& scene);

/// Returns a point of the part in the half plane of a tool.
[[nodiscard]] Vec2 in_tool(const Pose& pose, const Vec3& point);

/// Returns how deep a point is in the heads; 0 where it is in none. Cost: O(facets).
[[nodiscard]] double depth_in_heads(const ClaimedScene& scene, const RigidTransform& frame, const Vec3& point);

/// Returns the signed distance of a point from the heads, negative in one; infinite where there are none. Cost:
/// O(facets).
[[nodiscard]] double distance_from_heads(const ClaimedScene& scene, const RigidTransform& frame, const Vec3& point);

/// Returns the reason why a claim about a witness, or its numbers, is wrong; none where it is right.
[[nodiscard]] std::optional<std::string> find_witness_fault(const ClaimedScene& scene, const ClaimedTools& tools,
                                                            std::size_t move, const MoveClaim& claim);

}  // namespace gouge
