#pragma once

#include <cstddef>
#include <string>

#include "postproc/gcode/running/program_text.h"

namespace gouge {

/// A block of a Klartext program, which may stand on several lines.
struct KlartextBlock {
  std::string text;                ///< capitals except between quotation marks; without number and comment
  std::string comment;             ///< of a block that is a comment or a structure item alone
  std::string error;               ///< why the text is no block; empty: it is one
  bool is_skippable = false;       ///< begins with the mark for block skip
  bool has_several_lines = false;  ///< a tilde joins another line
  std::size_t next_index = 0;      ///< the line after the block
};

/// Reads the block that begins at a line. A tilde at the end of a line joins the next one.
/// Source   iTNC 530 60642x-04: comments after a semicolon, structure items after an asterisk, cycles with a tilde.
[[nodiscard]] KlartextBlock read_klartext_block(const ProgramText& text, std::size_t index);

/// Reads a block of one line.
[[nodiscard]] KlartextBlock read_klartext_line(std::string_view line);

/// Shortens a text by words at its start, which blanks separate. False: it begins otherwise, and stays as it is.
[[nodiscard]] bool take_keywords(std::string_view& text, std::string_view keywords);

}  // namespace gouge
