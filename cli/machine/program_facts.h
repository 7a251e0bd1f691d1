#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Facts about a program of a machine's control as the user states them. Empty: not stated.
struct StatedProgram {
  std::string control;
  std::vector<std::string> offsets;  ///< "G54=x,y,z[,a,b,c]"
  std::string tool_lengths;          ///< a file: parse_tool_lengths
  std::vector<std::string> start;    ///< blocks in force at the start
  std::vector<std::string> tip_control_ends;
  std::string block_delete;   ///< "on" or "off"
  std::string home;           ///< "x,y,z"
  std::string plain_numbers;  ///< "units" or "increments"
  std::string rotary_turns;   ///< "as-programmed"
  std::string tip_frame;      ///< "table", "table-at-zero", "table-at-call" or "workpiece"
};

/// Names of these options in messages: those of the command line, or others.
struct ProgramOptionNames {
  std::string offset = "--offset", home = "--home", block_delete = "--block-delete", plain_numbers = "--plain-numbers",
              rotary_turns = "--rotary-turns", tip_frame = "--tip-frame";
};

/// Returns the facts that the texts state, without the lengths of tools and the machine.
/// Errors (code usage): an offset of another form, or one that is stated twice; a home position that is no three lengths; a
/// word that is none of an option's values.
[[nodiscard]] Result<ProgramSetup> understand_program(const StatedProgram& stated,
                                                      const ProgramOptionNames& names = {});

/// Reads lengths of tools: CSV with the heading tool,length, or a tool table of LinuxCNC with T and Z, and its diameters D,
/// or one of Heidenhain. In mm. A tool with an offset of another axis than Z has kSidewaysLength.
/// Error: tool-lengths, with the line: a row of another form, a tool twice, or no row.
/// Source   LinuxCNC, Tool Table: T tool number, Z tool length offset, D tool diameter.
[[nodiscard]] Result<ToolTable> parse_tool_lengths(const std::string& file, std::string_view text);

/// Puts the facts of a tool table in their places.
void take_tool_table(ToolTable table, ProgramSetup& setup);

}  // namespace gouge
