#pragma once

#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Returns whether a text is a tool table of a Heidenhain control: BEGIN TOOL.T in its first line.
[[nodiscard]] bool is_heidenhain_tool_table(std::string_view text);

/// Reads a tool table (TOOL.T): the lengths L and DL, which the control adds, the radii R and DR, and the corner radii R2
/// and DR2. A tool without L has no length, one without R no diameter, and one without R2 no corner radius.
/// Errors (code tool-lengths), with the line: no unit, no heading with T and L, a row of another form or with a value that
/// stands in two columns, a tool twice, or no
/// [END], so that rows may be missing.
/// Source   TNC7 81762x-17, tool table tool.t: T, L, R, R2, DL, DR and DR2. The values stand below the words of the heading.
[[nodiscard]] Result<ToolTable> read_heidenhain_tool_table(const std::string& file, std::string_view text);

}  // namespace gouge
