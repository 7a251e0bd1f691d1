#pragma once

#include <string>

#include "lib/base/units.h"
#include "lib/geom/rigid_transform.h"
#include "postproc/report/report_model.h"
#include "toolmodels/assembly.h"

// What a result says of the set-up it holds for, so that another one can be told from it.

namespace gouge {

/// 32 hexadecimal digits, the same for equal units and equal places of the STL files, however they were typed.
[[nodiscard]] std::string placement_identity(const RigidTransform& place, LengthUnit stl_unit);

/// ToolFacts::identity and ::bodies of a tool as it is checked: by its dimensions, whatever its name and number.
/// `is_extended_up`: with a top body that goes on without end.
void identify_tool(const ToolAssembly& tool, bool is_extended_up, ToolFacts& facts);

}  // namespace gouge
