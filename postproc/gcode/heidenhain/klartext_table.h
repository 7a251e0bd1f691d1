#pragma once

#include <cstdint>
#include <span>
#include <string_view>

// Meanings of the miscellaneous functions and the cycles of the control. docs/formats/gcode_heidenhain.md has the sources.

namespace gouge {

enum class KlartextMeaning : std::uint8_t {
  harmless,        ///< neither moves nor changes anything
  spindle_on,      ///< M3, M4, M13, M14
  spindle_off,     ///< M5, M19
  program_end,     ///< M2, M30
  tip_control_on,  ///< M128
  tip_control_off,
  machine_place,    ///< M91: coordinates from the machine datum in this block
  unknown_place,    ///< coordinates from a place that only the machine knows
  shortest_on,      ///< M126: rotary axes take the shorter way
  shortest_off,     ///< M127
  cycle_call,       ///< M99
  per_minute,       ///< M137
  per_revolution,   ///< M136
  retract,          ///< M140: a motion along the tool axis
  tool_change,      ///< M6: where the machine goes is its builder's
  not_checked_path  ///< later motions leave the programmed path
};

/// An M function. One row a number; no code depends on the row.
struct KlartextFunction {
  int number = 0;
  KlartextMeaning meaning = KlartextMeaning::harmless;
  std::string_view note = {};  ///< why later motions are not checked
};

/// Returns the row of an M function; null: there is none.
[[nodiscard]] const KlartextFunction* find_klartext_function(int number);

enum class KlartextDrilling : std::uint8_t {
  rapid_out,   ///< in by feed on the line of the hole, out by rapid
  feed_out,    ///< in and out by feed
  not_checked  ///< moves across the hole
};

/// A cycle with Q parameters that runs when it is called.
struct KlartextCycle {
  int number = 0;
  KlartextDrilling form = KlartextDrilling::rapid_out;
  int zero_parameter = 0;      ///< a parameter that must be 0 if it is stated; 0: none
  bool needs_zero = false;     ///< it must be stated
  std::string_view note = {};  ///< why it is not checked
};

/// Returns the row of a cycle; null: there is none.
[[nodiscard]] const KlartextCycle* find_klartext_cycle(int number);

[[nodiscard]] std::span<const KlartextFunction> klartext_functions();
[[nodiscard]] std::span<const KlartextCycle> klartext_cycles();

}  // namespace gouge
