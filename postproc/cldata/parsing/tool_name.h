#pragma once

#include <string_view>

namespace gouge {

/// True of the text that SolidWorks CAM writes before a CUTTER: it has a dimension with its unit, or a word for a kind
/// of tool, and nothing of a macro outside of square brackets.
[[nodiscard]] bool is_tool_name(std::string_view text);

/// True of the two other texts that SolidWorks CAM writes by itself: "Stock Size X95. Y95. Z10." and "STOP" with a
/// message for the operator.
[[nodiscard]] bool is_setup_text(std::string_view text);

}  // namespace gouge
