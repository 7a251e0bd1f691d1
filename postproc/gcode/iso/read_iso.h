#pragma once

#include "postproc/gcode/language/control_table.h"
#include "postproc/gcode/running/program_language.h"

namespace gouge {

/// Runs a program of words of one letter (ISO 6983), by the table of its control.
[[nodiscard]] ProgramFacts run_iso(const ControlTable& control, const ProgramInput& input);

/// Returns whether a text is certainly such a program: its first lines are blocks.
[[nodiscard]] bool is_iso_program(std::string_view bytes);

}  // namespace gouge
