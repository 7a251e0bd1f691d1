#pragma once

#include <string>

#include "lib/base/units.h"
#include "lib/geom/pose.h"
#include "postproc/report/report_model.h"
#include "toolmodels/assembly.h"

// Short texts by which acceptances and comparisons recognize the same set-up.

namespace gouge {

/// Returns 32 hexadecimal digits that are equal for equal units and equal places of the STL files, in any notation.
[[nodiscard]] std::string placement_identity(const RigidTransform& place, LengthUnit stl_unit);

/// Sets ToolFacts::identity and ::bodies of a tool. The identity depends on the contours of its bodies, rounded to a
/// nanometre: not on its name, on the words that describe its shape, or on their unit. With `is_extended_up` its top body
/// has no end. A tool that make_body_profiles refuses gets no identity.
void identify_tool(const ToolAssembly& tool, bool is_extended_up, ToolFacts& facts);

}  // namespace gouge
