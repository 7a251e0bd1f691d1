#pragma once

#include <string>

#include "postproc/gcode/language/control_table.h"
#include "postproc/gcode/reading/block_runner.h"
#include "postproc/gcode/running/program_motion.h"

namespace gouge {

/// Facts about a program that was read.
struct ProgramFacts {
  std::size_t unit_line = 0;    ///< block that states the unit; 0: none
  std::size_t offset_line = 0;  ///< block that chooses the work offset; 0: none
  std::size_t end_line = 0;     ///< block that ends the program; 0: none
  bool has_unit_option = false;
  bool is_control_stated = false;  ///< by an option, else by the machine file
};

/// Returns the facts on which a verdict on a program rests: its unit, control, completeness, words, and frame.
[[nodiscard]] Assumptions assume_program(const Toolpath& path, const ControlTable& control, const ProgramSetup& setup,
                                         const ProgramMotion& motion, const ProgramFacts& facts);

}  // namespace gouge
