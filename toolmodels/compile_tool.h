#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/motion_tube.h"
#include "lib/tool/tool_variants.h"
#include "toolmodels/assembly.h"
#include "toolmodels/profile.h"

// From a contour to the structure the check evaluates: elements with their support ranges, the BSP over their
// Voronoi diagram, extent and core.

namespace gouge {

/// Requires  verify_profile(profile).empty(), or a profile without elements (gives a tool without elements).
/// Ensures   (1) Indices are in range, every element is owned by a leaf, normals are unit vectors, and elements join.
///           Extent and core fit. (2) The contract of evaluate.h. (3) The contract of SupportRange.
/// Cost      Milliseconds for a tool of twenty elements.
/// Source    Ho 1999, thesis 2.4.18, appendix C; docs/method/tool_voronoi.md
[[nodiscard]] CompiledTool compile_tool(const std::string& name, const Profile& profile);

/// Makes all variants a check needs. Growth is rounded: the body's solid of revolution plus a ball. With a tube every
/// variant is the union of all places that the tool takes within it.
///
/// Ensures   With `has_wide` also ToolVariants::wide. It is, for every body, the solid of revolution of its contour
///           moved out by the diameter of the cutter. That holds every place the body takes that far beside the axis.
/// Requires  The three lengths are finite and >= 0.
/// Errors    Those of make_body_profiles, of sweep_tilts and of unite.
[[nodiscard]] Result<ToolVariants> make_tool_variants(const ToolAssembly& tool, double stock_to_leave_mm,
                                                      double shank_clearance_mm, double holder_clearance_mm,
                                                      bool has_wide = false, const MotionTube& tube = {});

/// Returns the same of shank and holder alone, as if the tool had no cutter: no elements where it has neither.
/// Errors    As make_tool_variants.
[[nodiscard]] Result<ToolVariants> make_non_cutting_variants(const ToolAssembly& tool, double shank_clearance_mm,
                                                             double holder_clearance_mm, const MotionTube& tube = {});

}  // namespace gouge
