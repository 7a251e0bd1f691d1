#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/units.h"

// Effects of text for a machine's control that a CL file passes on unchanged (INSERT, PREFUN, manual entries): G-code,
// Heidenhain and Siemens words, macros. The text is not interpreted as motion. It is harmless only if every one of its
// words is in the list of control_list.h.

namespace gouge {

/// A code that stays in force for the positions that follow: G0, G1, or one of the arcs and threads.
enum class MotionCode : std::uint8_t { rapid, straight, other };

/// The plane of arcs and cycles: G17, G18, G19.
enum class ControlPlane : std::uint8_t { xy, zx, yz };

/// All possible effects of a text. Several may hold; none holds for text that neither moves nor changes anything.
struct MachineEffect {
  bool moves = false;                     ///< the tool moves to an unknown position
  bool shifts = false;                    ///< shifts, turns, scales, mirrors or compensates later positions
  bool begins_cycle = false;              ///< every later position runs a cycle (G81, MCALL CYCLE81)
  bool ends_cycle = false;                ///< G80, or MCALL alone
  bool begins_steps = false;              ///< later numbers are steps (G91)
  bool ends_steps = false;                ///< G90, after any G91 of the text
  bool changes_tool = false;              ///< M6, TOOL CALL
  bool changes_length = false;            ///< changes the tool length in the control: G43, G44, G49
  bool ends_program = false;              ///< M2, M30
  bool smooths = false;                   ///< the control may leave the path: G187 P3, CYCLE832(0.1), G642
  bool is_unknown = false;                ///< a word is not in the list: it may have any effect
  std::string work_offset;                ///< the work offset that it chooses ("G54", "G54.1P3"); empty: none
  std::optional<MotionCode> motion_code;  ///< G0, G1 or another one, which may be wrong for later positions
  bool ends_compensation = false;         ///< G40
  bool ends_tilt = false;                 ///< ends a tilted plane: G69, G255
  bool turns_axes = false;                ///< the rotary joints run in proportion: ORIAXES
  std::optional<double> smoothing;        ///< the distance of `smooths`, if stated, in the unit of the control
  std::optional<ControlPlane> plane;      ///< G17, G18, G19
  std::optional<bool> centres_absolute;   ///< G90.1; false: G91.1
  std::optional<bool> level_at_start;     ///< cycles retract to the level at which they began: G98; false: G99
  std::optional<bool> stops_spindle;      ///< M5, M19; false: M3, M4, M13, M14
  std::optional<LengthUnit> unit;         ///< unit of later numbers (G20, G21, G70, G71)
};

/// Returns whether the text moves or changes anything.
[[nodiscard]] inline bool has_effect(const MachineEffect& effect) {
  return effect.moves || effect.shifts || effect.begins_cycle || effect.ends_cycle || effect.begins_steps ||
         effect.ends_steps || effect.changes_tool || effect.changes_length || effect.ends_program ||
         effect.is_unknown || effect.ends_compensation || effect.ends_tilt || effect.turns_axes ||
         !effect.work_offset.empty() || effect.unit || effect.motion_code || effect.plane || effect.centres_absolute ||
         effect.level_at_start;
}

/// Returns whether the text may end or change a drilling cycle that is in force.
[[nodiscard]] inline bool changes_cycle(const MachineEffect& effect) {
  return effect.begins_cycle || effect.ends_cycle || effect.begins_steps || effect.ends_steps || effect.motion_code ||
         effect.plane || effect.level_at_start || effect.ends_tilt;
}

/// Reads one block. Block numbers, program names and comments have no effect. Comments are in brackets, except the
/// functions of an Osai control, or after a semicolon, if that text is not a block. A block that the control may leave
/// out (a slash) is unknown if it has an effect.
[[nodiscard]] MachineEffect read_machine_text(std::string_view text);

}  // namespace gouge
