#pragma once

#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Returns whether a text is a tool table of a Heidenhain control: BEGIN TOOL.T in its first line.
[[nodiscard]] bool is_heidenhain_tool_table(std::string_view text);

/// Reads a tool table (TOOL.T): the lengths L and DL, which the control adds, and the radii R and DR. A tool without L has
/// no length, and one without R no diameter.
/// Errors (code tool-lengths), with the line: no unit, no heading with T and L, a row of another form, a tool twice, or no
/// [END], so that rows may be missing.
/// Source   TNC7 81762x-17, tool table tool.t: T, L, R, DL and DR. The values stand below the words of the heading.
[[nodiscard]] Result<ToolTable> read_heidenhain_tool_table(const std::string& file, std::string_view text);

}  // namespace gouge
