#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

// Tables of codes and their effects: one for each control. A code without a row is not understood.

namespace gouge {

/// Effect of a code on the state of the program. The tables give each code one of these; only the runner interprets them.
enum class GcodeMeaning : std::uint8_t {
  harmless,  ///< neither a motion nor a change of later positions
  spindle_on,
  spindle_off,  ///< also the stop at an angle
  rapid,
  feed,
  arc_clockwise,
  arc_counterclockwise,
  no_motion,  ///< G80: ends a cycle; axis words need a motion code
  cycle,      ///< a drilling cycle of the table of cycles
  plane_xy,
  plane_zx,
  plane_yz,
  inch,
  mm,
  absolute,
  incremental,
  centre_absolute,     ///< I J K are a point
  centre_incremental,  ///< I J K are steps from the start
  feed_inverse,
  feed_per_minute,
  feed_per_revolution,
  cycle_to_start,  ///< G98: cycles retract to the level at which they began
  cycle_to_plane,  ///< G99: cycles retract to R
  work_offset,     ///< the code, with P for an extended one, names the offset
  machine_place,   ///< axis words of this block are machine coordinates
  home,            ///< named axes go home by way of a point
  length_on,       ///< tool length by H
  length_off,      ///< ends tool length, and tool centre point control
  tip_control_on,  ///< tool centre point control, with the length of H
  tip_control_off,
  turned_offset_on,  ///< the work offset follows the rotary joints, the axes stay those of the machine
  turned_offset_off,
  tilted_plane,      ///< later positions are in a tilted frame
  align_to_plane,    ///< the rotary joints align the tool with the tilted frame
  tilted_plane_off,  ///< ends all frames of the program
  blending,  ///< later motions leave the path by the words GcodeRow::distance; without them by an unknown distance
  tool_change,
  program_end,
  call_program,
  call_block,
  return_from_call,
  not_checked  ///< understood, but its motions cannot be checked; the row's note is the reason
};

/// Codes of one group replace each other; a block has at most one of each group, except of `none`.
enum class ModalGroup : std::uint8_t {
  none,
  motion,
  plane,
  distance,
  centre,
  feed_mode,
  unit,
  compensation,
  length,
  cycle_return,
  work_offset,
  path_control,
  frame,
  cycle_end  ///< G80 on controls where it is no motion code: it may stand beside one that is not a cycle
};

/// Number of a code, times ten: 434 is G43.4.
using CodeNumber = int;

struct GcodeRow {
  char letter;  ///< G or M
  CodeNumber number;
  GcodeMeaning meaning;
  ModalGroup group = ModalGroup::none;
  std::string_view words = {};   ///< addresses that the code takes besides axes and those that are always allowed
  bool takes_axes = true;        ///< axis words may be in its block
  std::string_view note = {};    ///< reason of not_checked
  std::string_view source = {};  ///< manual and page
  bool cancels_length = false;   ///< its motion may end the tool length; that of machine_place only if Z moves
  /// Words of blending whose sum is the distance. The first must be above 0; else the distance is not known.
  std::string_view distance = {};
};

/// Motions of a cycle after the rapid to R.
enum class DrillForm : std::uint8_t {
  feed_in_rapid_out,
  feed_in_feed_out,
  thread,      ///< as feed_in_feed_out, with the spindle reversed
  not_checked  ///< motions across the hole, or by hand
};

struct GcodeCycle {
  CodeNumber number;
  DrillForm form;
  std::string_view words;  ///< addresses that the cycle takes besides X, Y, Z and R
  std::string_view source;
};

/// Meaning of numbers without a decimal point in words of length, angle and feed.
enum class NumberRule : std::uint8_t {
  plain,    ///< X100 is 100
  by_point  ///< X100 is 100 of the smallest increments, or 100, as a parameter of the control states
};

/// Turns of absolute rotary words without the option that states them.
enum class RotaryTurns : std::uint8_t {
  as_programmed,    ///< the word states the turn too
  may_be_shorter,   ///< a parameter may shorten a way of half a turn or more
  may_follow_sign,  ///< besides, a parameter may let the sign state the direction: C-30 turns backwards to 30
};

/// Text that is no word.
struct GcodeSyntax {
  NumberRule numbers = NumberRule::plain;
  bool has_semicolon_comments = true;  ///< text after a semicolon is a comment; else a semicolon ends a block
  bool has_o_words = false;            ///< O begins a statement of program flow (LinuxCNC); else it names a program
  bool has_macros = false;             ///< IF, WHILE, GOTO of Fanuc's custom macros
  bool has_named_variables = false;    ///< #<name>
  bool binds_and_as_times = false;     ///< AND has the rank of *, OR and XOR that of + (Fanuc)
  bool has_equal_tolerance = false;    ///< EQ and NE compare within a tolerance (LinuxCNC)
  long long first_system_variable =
      1000;  ///< variables from this number are those of the control: offsets, lengths, timers
};

/// A control whose programs have words of one letter (ISO 6983).
struct ControlTable {
  std::string_view id;     ///< value of --control
  std::string_view title;  ///< name in messages
  GcodeSyntax syntax;
  std::span<const GcodeRow> rows;  ///< ascending by letter and number
  std::span<const GcodeCycle> cycles;
  std::string_view always;              ///< addresses that every block may have
  std::string_view start;               ///< blocks in force at the start by the manual; others must be stated
  std::string_view length_motion = {};  ///< parameter that states whether a code of length moves Z; empty: it does not
  bool rounds_steps = true;             ///< incremental words round to an increment
  bool cycles_follow_mode = false;      ///< G90 and G91 of the block that drills count for R and Z stated before it
  bool cycles_count_from_start =
      true;                         ///< R of G91 counts from the level at which the cycle began; else from the present
  bool levels_may_be_new = false;   ///< the level of G98 may be that before a cycle that follows another one
  bool has_default_length = false;  ///< G43 without H takes the length of the tool in the spindle
  RotaryTurns turns = RotaryTurns::may_be_shorter;  ///< of absolute rotary words
  bool has_tip_frame_of_table =
      false;  ///< tool centre point control follows the table, and its coordinates are those with
              ///< the table at 0; else parameters state it
  bool shifts_words_of_joints =
      false;  ///< a work offset of a rotary joint shifts its words alone, and turns no coordinates
  bool has_straight_rapids =
      false;  ///< G0 without tool centre point control is coordinated; else a parameter states it
  bool takes_rapids_to_machine_places = false;  ///< G53 is a rapid whatever motion code is in force
  bool goes_apart_to_machine = false;           ///< G28 and G53 run each axis at its own rate, whatever rapids do
  bool turns_along_arcs = false;                ///< rotary joints may turn along an arc, evenly with it
  bool may_load_waiting_tool = false;  ///< M6 beside T may load the tool of an earlier T, and make the new one ready
  std::size_t program_digits = 0;      ///< digits of P of a call before these may be its repeats; 0: they never are
  std::string_view source;
};

/// Returns the row of a code; null: the control's table has none.
[[nodiscard]] const GcodeRow* find_row(const ControlTable& control, char letter, CodeNumber number);
[[nodiscard]] const GcodeCycle* find_cycle(const ControlTable& control, CodeNumber number);

}  // namespace gouge
