#pragma once

#include <optional>
#include <vector>

#include "postproc/gcode/iso/block_words.h"
#include "postproc/gcode/running/program_language.h"
#include "postproc/gcode/running/program_text.h"

namespace gouge {

/// Finds the first motions of a file that do not run and belong to no subprogram: those of another main program, those behind
/// the percent sign at the end, and those behind the end of the program to which nothing leads.
///
/// Expects  `has_run` has one value for each line of `text`. `may_jump`: a statement of program flow ran, so that blocks
///          behind the end may belong to the program.
/// Ensures  A program that ends with M99 before the end mark is a subprogram. Nothing: there are no such motions.
[[nodiscard]] std::optional<OtherProgram> find_other_program(const ProgramText& text, const CodeIndex& index,
                                                             const std::vector<bool>& has_run, bool may_jump);

}  // namespace gouge
