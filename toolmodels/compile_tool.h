#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/motion_tube.h"
#include "lib/tool/tool_variants.h"
#include "toolmodels/assembly.h"
#include "toolmodels/profile.h"

// Builds, from a contour, the structure that the check evaluates: elements with their support ranges, the BSP over
// their Voronoi diagram, extent and core.

namespace gouge {

/// Requires  verify_profile(profile).empty(), or a profile without elements (gives a tool without elements).
/// Ensures   (1) Indices are in range, every element is owned by a leaf, normals are unit vectors, and elements join.
///           Extent and core are those of the elements. (2) The contract of evaluate.h. (3) The contract of
///           SupportRange.
/// Cost      Milliseconds for a tool of twenty elements.
/// Source    Ho 1999, thesis 2.4.18, appendix C; docs/method/tool_voronoi.md
[[nodiscard]] CompiledTool compile_tool(const std::string& name, const Profile& profile);

/// Makes all variants of a tool that a check needs. Growth is rounded: the solid of revolution of a body plus a ball. With
/// a tube every variant is the union of all places that the tool takes within it.
///
/// Ensures   With `has_wide` the result also has ToolVariants::wide. For every body that is the solid of revolution of
///           its contour moved out by the diameter of the cutter. It contains every place that the body takes when its
///           axis is moved sideways by at most that distance.
/// Requires  The three lengths are finite and >= 0.
/// Errors    Those of make_body_profiles, of sweep_tilts and of unite.
[[nodiscard]] Result<ToolVariants> make_tool_variants(const ToolAssembly& tool, double stock_to_leave_mm,
                                                      double shank_clearance_mm, double holder_clearance_mm,
                                                      bool has_wide = false, const MotionTube& tube = {});

/// Returns the variants of shank and holder alone, as if the tool had no cutter. They have no elements if the tool has
/// neither.
/// Errors    Those of make_tool_variants.
[[nodiscard]] Result<ToolVariants> make_non_cutting_variants(const ToolAssembly& tool, double shank_clearance_mm,
                                                             double holder_clearance_mm, const MotionTube& tube = {});

}  // namespace gouge
