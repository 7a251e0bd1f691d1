#pragma once

#include <string_view>

#include "postproc/gcode/running/program_language.h"

namespace gouge {

/// Runs a program of a Heidenhain control in Klartext. docs/formats/gcode_heidenhain.md lists the words and their sources.
[[nodiscard]] ProgramFacts run_heidenhain(const ProgramInput& input);

/// Returns whether a text is certainly such a program: BEGIN PGM with MM or INCH is its first block.
[[nodiscard]] bool is_heidenhain_program(std::string_view bytes);

}  // namespace gouge
