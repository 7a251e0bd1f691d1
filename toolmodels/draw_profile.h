#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/base/units.h"
#include "lib/drawing/drawing.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// Draws a sheet about one tool, after thesis figures 21 and 22. On the left is the assembly with its bodies in colour,
/// its Voronoi regions and dimensions. On the right is the tip, enlarged, with the regions inside and outside. Arrows
/// at the points of a grid show the directions of correction: the shortest way out.
///
/// Ensures  The same tool gives the same drawing; dimensions are written in `unit`.
/// Errors   Those of make_body_profiles.
[[nodiscard]] Result<Drawing> draw_profile(const ToolAssembly& tool, LengthUnit unit);

/// Draws every tool in a field of its own, in rows: the whole assembly small, its cutter large, name and dimensions.
///
/// Errors   Those of make_body_profiles.
[[nodiscard]] Result<Drawing> draw_sheet(const std::vector<const ToolAssembly*>& tools, LengthUnit unit);

/// Returns the cutter in one line for captions and lists: "cutter flat D 10 mm, ...".
[[nodiscard]] std::string describe_cutter(const Cutter& cutter, LengthUnit unit);

}  // namespace gouge
