#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/units.h"
#include "lib/path/toolpath.h"
#include "postproc/gcode/running/program_motion.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Options of the user for a program.
struct GcodeOptions {
  ProgramSetup setup;
  std::optional<LengthUnit> unit;           ///< for a program that states none
  std::vector<std::string> harmless_words;  ///< codes that neither move nor change anything: "M200"
  std::string unnamed_tool;                 ///< name of the tool of moves before a tool change; empty: they have none
};

/// Data on which the reader of a language works. Toolpath::source and ::statements (its lines that are not blank) are there.
struct ProgramInput {
  const GcodeOptions& options;
  Toolpath& path;
  ProgramMotion& motion;
  const ProgressCall& progress;
};

/// Motions of the file that do not run and belong to no subprogram.
struct OtherProgram {
  std::string evidence;
  std::size_t line = 0;
};

/// Evidence of motions to which nothing leads.
inline constexpr const char* kBlocksBehindEnd =
    "blocks stand behind the end of the program, and no jump or call leads to them";

/// Facts that the reader of a language finds, besides the moves.
struct ProgramFacts {
  std::size_t unit_line = 0;          ///< block that states the unit; 0: none
  bool has_assumed_unit = false;      ///< a length stands before the block that states the unit
  std::string unit_word;              ///< "G20"; Toolpath::unit has the unit
  std::size_t offset_line = 0;        ///< block that chooses the work offset; 0: none
  std::size_t end_line = 0;           ///< block that ends the program; 0: none
  std::size_t loading_line = 0;       ///< first T that is taken to load its tool without M6; 0: none
  std::optional<OtherProgram> other;  ///< motions that do not run, and may be those of another program
  std::optional<Diagnostic> error;    ///< the program cannot be read at all: a rotary word without its machine
};

/// A control and the reader of its programs. One row a control; no code depends on the row.
struct ProgramLanguage {
  std::string_view id;     ///< value of --control
  std::string_view title;  ///< name in messages
  /// Runs a program to its end, or until nothing after it is known (ProgramDoubt::rest).
  ProgramFacts (*run)(const ProgramInput& input);
  /// A comment may hold a carriage return within its line; `run` decides on the text behind it.
  bool may_return_in_comment = false;
};

/// Names another word that is not understood, after the knowledge of the program ended, so that the user can mend all at once.
/// A reason that is listed already, and reasons beyond a number that a person reads, are left out.
void note_further_word(const std::string& reason, std::size_t line, const ProgramInput& input);

/// Returns the words of a program that are not understood, each after "line N: ", in the order of their lines.
[[nodiscard]] std::vector<std::string> words_by_line(const Toolpath& path);

/// Adds a warning (gcode-word) and a move that is not checked, and ends the knowledge of all that follows.
void lose_program(const std::string& reason, std::size_t line, const ProgramInput& input);

}  // namespace gouge
