#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "postproc/gcode/language/control_table.h"

// The words of Siemens 840D that are understood, as data. A word without a row is not understood.

namespace gouge {

enum class SiemensMeaning : std::uint8_t {
  harmless,  ///< neither moves nor changes later motions
  spindle_on,
  spindle_off,  ///< also the stop at an angle
  not_checked,  ///< later motions cannot be checked until another word of its group; the row's note is the reason
  rapid,
  line,
  arc_clockwise,
  arc_counterclockwise,
  arc_by_point,  ///< CIP
  dwell,         ///< G4: F and S of its block are times
  plane_xy,
  plane_zx,
  plane_yz,
  absolute,
  incremental,
  mm,
  inch,
  feed_inverse,
  feed_per_minute,
  feed_per_revolution,
  work_offset,
  machine_axes,  ///< the block states places of the axes of the machine
  basic_axes,    ///< the block states places in the basic frame, which only the control knows
  compensation_off,
  exact_path,
  smooth_path,       ///< leaves the path by a distance that only the control knows
  smooth_distance,   ///< leaves it by at most ADIS
  smooth_tolerance,  ///< leaves it by at most CTOL
  compressor_on,
  compressor_off,
  rapid_straight,
  rapid_apart,
  turn_by_vector,
  turn_by_axis,
  tip_control_on,
  tip_control_off,
  translate,
  rotate,
  scale,
  mirror,
  tool_change,
  program_end,
  back,  ///< ends a subprogram
  message,
  swivel,     ///< CYCLE800
  smoothing,  ///< CYCLE832
  drill,
  modal_call,
  leave_to_fixed_point  ///< motion to a place that only the control knows
};

/// Words of one group replace each other. A block has at most one of each group, except of `none`.
enum class SiemensGroup : std::uint8_t {
  none,
  motion,
  plane,
  compensation,
  work_offset,
  suppression,
  path_control,
  unit,
  distance,
  feed,
  compressor,
  rapid_kind,
  turn_frame,  ///< ORIWKS ORIMKS
  turn_path,   ///< ORIVECT ORIAXES
  transformation,
  frame
};

struct SiemensRow {
  std::string_view name;
  SiemensMeaning meaning;
  SiemensGroup group = SiemensGroup::none;
  bool is_alone = false;         ///< its block has no axis words besides its own
  bool takes_arguments = false;  ///< values in brackets may follow
  bool is_additive = false;      ///< of a frame: added to the one in force
  std::string_view note = {};
};

struct SiemensCycle {
  std::string_view name;
  DrillForm form;
  std::size_t known_arguments;  ///< so many arguments keep the tool on the line of the hole; others must be empty or 0
};

[[nodiscard]] std::span<const SiemensRow> siemens_rows();
/// Returns the row of a word, in capitals; null: the table has none. G505 to G599 share the row of G505.
[[nodiscard]] const SiemensRow* find_siemens_row(std::string_view name);
[[nodiscard]] const SiemensCycle* find_siemens_cycle(std::string_view name);
/// Returns whether a word with a value is of no effect on motions: S, SPOS, LIMS.
[[nodiscard]] bool is_harmless_value(std::string_view name);

}  // namespace gouge
