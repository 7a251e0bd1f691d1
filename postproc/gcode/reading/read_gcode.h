#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"
#include "postproc/gcode/running/program_language.h"
#include "postproc/program/read_outcome.h"

namespace gouge {

/// Returns all controls whose programs are read, in the order for the user.
[[nodiscard]] std::span<const ProgramLanguage> all_languages();
/// Returns "linuxcnc, haas, fanuc or siemens".
[[nodiscard]] std::string language_names();

/// Returns whether a text is certainly a program of one of them.
[[nodiscard]] bool is_gcode(std::string_view bytes);

/// Reads a program of a control as the control runs it.
///
/// Units    Coordinates become mm and part coordinates: those of the work offset that the program chooses first, or of
///          ProgramSetup::zero.
/// Ensures  (1) Each motion is one move with the line of its block, or of the call in the file. (2) After a word that is
///          not understood no move is checked. (3) With a machine, Toolpath::joints has the angles that the program states,
///          with their turns. (4) Moves::runs_joints states which moves run without tool centre point control.
/// Errors   Codes: path-empty, path-too-long, path-binary, path-no-motion; path-unit: the program states another unit
///          than the options; gcode-control: no control is stated, or one that is not known; gcode-machine: a rotary word
///          without a machine that has the axis.
/// Cost     One pass. About 10 million words a second. Memory is the file, 104 bytes for each move, 12 for each line, and 48
///          for each move of a machine.
[[nodiscard]] ReadOutcome read_gcode(const std::string& file_name, SourceText bytes, const GcodeOptions& stated,
                                     const ProgressCall& progress);

}  // namespace gouge
