#pragma once

#include <optional>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/units.h"
#include "lib/check/closeness.h"
#include "lib/check/scene.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A warning where a path can hardly belong to the parts it is checked against: no part comes as near to the box of its
/// tips as a tool could reach (`tool_mm`, the longest distance from a tip to a point of a tool), or all parts together
/// are many times smaller than what it cuts, as with a wrong unit. Where another unit than `stl_unit`, in which the STL
/// files were read, would make the sizes agree, the message names it. Nothing where there is no part or no motion.
[[nodiscard]] std::optional<Diagnostic> find_misplaced(const Toolpath& path, const Scene& scene, double tool_mm,
                                                       LengthUnit stl_unit = LengthUnit::mm);

/// The same warning where the part is many times larger than what the path cuts, another unit would make the sizes
/// agree, and most cuts gouge or are buried. `verdicts`: those on the path.
[[nodiscard]] std::optional<Diagnostic> find_too_large(const Toolpath& path, const Scene& scene,
                                                       const MoveVerdicts& verdicts, LengthUnit stl_unit);

/// The same warning where the tool was not seen near the part while it cuts, though it is not far from it. Nothing
/// where too few positions were looked at to say so.
[[nodiscard]] std::optional<Diagnostic> find_apart(const Toolpath& path, const Closeness& closeness);

}  // namespace gouge
