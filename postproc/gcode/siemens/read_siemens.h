#pragma once

#include <string_view>

#include "postproc/gcode/running/program_language.h"

namespace gouge {

/// Returns whether a text is certainly a program of a Siemens control: numbered blocks, and words that no other control
/// has.
[[nodiscard]] bool is_siemens_program(std::string_view bytes);

/// Runs a program of a Siemens 840D.
/// Source   docs/formats/gcode_siemens.md.
[[nodiscard]] ProgramFacts run_siemens(const ProgramInput& input);

}  // namespace gouge
