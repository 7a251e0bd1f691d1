#pragma once

#include <string>
#include <vector>

#include "cli/options/reading_options.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// The group of options about programs of a machine's control.
inline constexpr const char* kProgramGroup = "Program";

/// Returns the values of --control.
[[nodiscard]] std::vector<std::string> control_ids();

/// Returns the facts about a program that the options state, without the machine.
/// Errors (code usage): an offset of another form, or one that is stated twice; a home position that is no three lengths.
[[nodiscard]] Result<ProgramSetup> understand_program(const ReadingArguments& arguments);

/// Reads lengths of tools: CSV with the heading tool,length, a tool table of LinuxCNC with T and Z, or TOOL.T of a
/// Heidenhain control. In mm.
/// Error: tool-lengths, with the line: a row of another form, a tool twice, or no row.
/// Source   LinuxCNC, Tool Table: T tool number, Z tool length offset.
[[nodiscard]] Result<std::map<int, double>> parse_tool_lengths(const std::string& file, std::string_view text);

}  // namespace gouge
