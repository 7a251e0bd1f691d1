#pragma once

#include <optional>
#include <string_view>

#include "lib/base/units.h"

// What text for a machine's control does that a CL file carries as it stands (INSERT, PREFUN, manual
// entries): G-code, Heidenhain and Siemens words, macros. Nothing of it is run; it is only distinguished by what
// it may do to the motion that follows.

namespace gouge {

/// All that a text may do. Several may hold; none holds of text that neither moves nor changes anything.
struct MachineEffect {
  bool moves = false;              ///< to an unknown position
  bool shifts = false;             ///< shifts, turns, scales, mirrors or compensates what follows
  bool begins_cycle = false;       ///< every position that follows runs a cycle (G81, MCALL CYCLE81)
  bool ends_cycle = false;         ///< G80, MCALL alone
  bool begins_steps = false;       ///< what follows are steps (G91)
  bool ends_steps = false;         ///< G90, after any G91 of the text
  bool changes_tool = false;       ///< M6, TOOL CALL
  bool changes_length = false;     ///< of the tool, in the control: G43, G44, G49
  bool chooses_offset = false;     ///< G54 and the like
  bool is_unknown = false;         ///< words of a control, a macro or a call that are not known
  std::optional<LengthUnit> unit;  ///< of the numbers that follow (G20, G21, G70, G71)
};

/// Reads one block. Comments in brackets or after a semicolon, block numbers and words that only switch
/// something (M8, S, F, T) do nothing. Sentences do nothing either: no control runs them. Where
/// `may_be_name`, as names of tools stand in the same place, only whole blocks of address words and known
/// words count.
[[nodiscard]] MachineEffect read_machine_text(std::string_view text, bool may_be_name);

}  // namespace gouge
