#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/verify/claims.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"

// Depths at one point and one instant, by the definition alone. They use the pose of the file, every piece of the
// contour and every facet of a head.

namespace gouge {

/// The contours of a tool that a claim can refer to.
struct ClaimedTool {
  explicit ClaimedTool(const ToolVariants& tool);
  ToolContour bare, part, fixture, clearance, non_cutting;
  /// The bodies of bare, part and fixture, each alone; empty: they were not made.
  std::vector<ToolContour> bare_alone, part_alone, fixture_alone;
};
using ClaimedTools = std::vector<std::unique_ptr<ClaimedTool>>;  ///< one for each entry of Toolpath::tools; null: not
                                                                 ///< defined
[[nodiscard]] ClaimedTools claimed_tools(const ClaimedScene& scene);

/// Returns a point, given in part coordinates, in the half plane of a tool.
[[nodiscard]] Vec2 in_tool(const Pose& pose, const Vec3& point);

/// Returns the depth of a point in the heads; 0 outside of them. Cost: O(facets).
[[nodiscard]] double depth_in_heads(const ClaimedScene& scene, const RigidTransform& frame, const Vec3& point);

/// Returns the signed distance of a point from the heads, negative inside one; infinite if there are no heads. Cost:
/// O(facets).
[[nodiscard]] double distance_from_heads(const ClaimedScene& scene, const RigidTransform& frame, const Vec3& point);

/// Returns the reason why a claim about a witness, or one of its numbers, is wrong; nothing if it is correct.
[[nodiscard]] std::optional<std::string> find_witness_fault(const ClaimedScene& scene, const ClaimedTools& tools,
                                                            std::size_t move, const MoveClaim& claim);

/// Returns the same about a further contact of a gouging move.
[[nodiscard]] std::optional<std::string> find_further_fault(const ClaimedScene& scene, const ClaimedTools& tools,
                                                            std::size_t move, const FurtherClaim& further);

}  // namespace gouge
