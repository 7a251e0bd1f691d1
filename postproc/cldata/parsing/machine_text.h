#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/base/units.h"

// Effects of text for a machine's control that a CL file carries unchanged (INSERT, PREFUN, manual
// entries): G-code, Heidenhain and Siemens words, macros. Nothing of it is run. It is harmless only if every one of its
// words is in the list of control_list.h.

namespace gouge {

/// All that a text may do. Several may hold; none holds of text that neither moves nor changes anything.
struct MachineEffect {
  bool moves = false;              ///< to an unknown position
  bool shifts = false;             ///< shifts, turns, scales, mirrors or compensates what follows
  bool begins_cycle = false;       ///< every position that follows runs a cycle (G81, MCALL CYCLE81)
  bool ends_cycle = false;         ///< G80, MCALL alone
  bool begins_steps = false;       ///< later numbers are steps (G91)
  bool ends_steps = false;         ///< G90, after any G91 of the text
  bool changes_tool = false;       ///< M6, TOOL CALL
  bool changes_length = false;     ///< of the tool, in the control: G43, G44, G49
  bool ends_program = false;       ///< M2, M30
  bool is_unknown = false;         ///< a word that is not in the list: it may do anything
  std::string work_offset;         ///< the one that it chooses ("G54", "G54.1P3"); empty: none
  std::optional<LengthUnit> unit;  ///< of the numbers that follow (G20, G21, G70, G71)
};

/// Reads one block. Block numbers, program names and comments do nothing. Comments are in brackets, except for the
/// functions of an Osai control, or behind a semicolon where they are not a block.
[[nodiscard]] MachineEffect read_machine_text(std::string_view text);

}  // namespace gouge
