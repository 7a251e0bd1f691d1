#pragma once

#include <string>
#include <string_view>

#include "postproc/gcode/lexing/expression.h"
#include "postproc/gcode/siemens/siemens_variables.h"

namespace gouge {

/// Reads an arithmetic or logical expression of Siemens at the cursor and moves the cursor behind it. Angles are in degrees.
/// Returns kUnknownValue for a value that depends on the control. On text that is no value, the cursor has an error.
/// Source   Siemens, NC programming, 12/2019, 6FC5398-2EP40-0BA0, p. 440 to 444: operations and their priority.
[[nodiscard]] double read_siemens_value(GcodeCursor& cursor, const SiemensVariables& variables);
/// Reads one number, variable or value in brackets, with its sign: no operator follows.
[[nodiscard]] double read_siemens_number(GcodeCursor& cursor);
/// Returns the length of the name with which a text begins; 0: it begins with none.
[[nodiscard]] std::size_t siemens_name_length(std::string_view text);
/// Reads a name in capitals: letters, digits, underscores and $. Empty: none is at the cursor.
[[nodiscard]] std::string read_siemens_name(GcodeCursor& cursor);

}  // namespace gouge
