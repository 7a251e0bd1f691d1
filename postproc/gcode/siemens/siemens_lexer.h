#pragma once

#include <string>
#include <string_view>

#include "postproc/gcode/siemens/siemens_block.h"
#include "postproc/gcode/siemens/siemens_variables.h"

namespace gouge {

/// Reads one line of a Siemens program into `block`, whose memory is used again. The values are those of the variables
/// before the block. Text that is no block gives SiemensBlock::error; the words before it stay.
/// Source   Siemens, NC programming, 12/2019, 6FC5398-2EP40-0BA0, 2.2 "Structure of an NC program".
void read_siemens_block(std::string_view line, const SiemensVariables& variables, SiemensBlock& block);

/// The parts of a line before its words.
struct SiemensLineStart {
  std::string label;           ///< LABEL of "LABEL: G0 X0", in capitals; empty: none
  std::string_view number;     ///< digits of N100; empty: none
  bool is_skippable = false;   ///< the mark for a block that may be skipped
  std::size_t first_word = 0;  ///< byte at which the words begin
};
[[nodiscard]] SiemensLineStart read_siemens_start(std::string_view line);

/// Returns a line up to its comment; a semicolon in a string begins none.
[[nodiscard]] std::string_view without_comment(std::string_view line);
/// Returns the statement of program flow with which the words of a line begin: "IF". Empty: it has none.
[[nodiscard]] std::string flow_word_of(std::string_view line);

}  // namespace gouge
