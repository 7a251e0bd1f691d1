#pragma once

#include <string_view>

#include "postproc/gcode/running/program_language.h"

namespace gouge {

/// Returns the facts on which a verdict on a program rests: its unit, control (by its name), completeness, words, and frame.
[[nodiscard]] Assumptions assume_program(const Toolpath& path, std::string_view control, const GcodeOptions& options,
                                         const ProgramMotion& motion, const ProgramFacts& facts);

}  // namespace gouge
