#include <array>

#include "postproc/gcode/language/control_tables.h"

namespace gouge {
namespace {

using enum GcodeMeaning;
using Group = ModalGroup;

constexpr std::string_view kCodes = "LinuxCNC, G-Code Reference", kOther = "LinuxCNC, M-Code Reference",
                           kKinematics = "LinuxCNC, configs/sim/axis/vismach/5axis/table-rotary-tilting/remap_subs";

// Ascending by letter and number.
constexpr auto kLinuxcncRows = std::to_array<GcodeRow>({
    {'G', 0, rapid, Group::motion, "", true, "", kCodes},
    {'G', 10, feed, Group::motion, "", true, "", kCodes},
    {'G', 20, arc_clockwise, Group::motion, "IJKRP", true, "", kCodes},
    {'G', 30, arc_counterclockwise, Group::motion, "IJKRP", true, "", kCodes},
    {'G', 40, harmless, Group::none, "P", false, "", kCodes},
    {'G', 170, plane_xy, Group::plane, "", true, "", kCodes},
    {'G', 180, plane_zx, Group::plane, "", true, "", kCodes},
    {'G', 190, plane_yz, Group::plane, "", true, "", kCodes},
    {'G', 200, inch, Group::unit, "", true, "", kCodes},
    {'G', 210, mm, Group::unit, "", true, "", kCodes},
    {'G', 280, home, Group::none, "", true, "", kCodes},
    {'G', 300, home, Group::none, "", true, "", kCodes},
    {'G', 400, harmless, Group::compensation, "", true, "", kCodes},
    {'G', 410, not_checked, Group::compensation, "D", true, "the path is compensated by the radius of the tool",
     kCodes},
    {'G', 420, not_checked, Group::compensation, "D", true, "the path is compensated by the radius of the tool",
     kCodes},
    {'G', 430, length_on, Group::length, "H", true, "", kCodes},
    {'G', 490, length_off, Group::length, "", true, "", kCodes},
    {'G', 530, machine_place, Group::none, "", true, "", kCodes},
    {'G', 540, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 550, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 560, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 570, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 580, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 590, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 591, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 592, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 593, work_offset, Group::work_offset, "", true, "", kCodes},
    {'G', 610, harmless, Group::path_control, "", true, "", kCodes},
    {'G', 611, harmless, Group::path_control, "", true, "", kCodes},
    {'G', 640, blending, Group::path_control, "PQ", true, "", kCodes, false, "PQ"},
    {'G', 730, cycle, Group::motion, "", true, "", kCodes},
    {'G', 800, no_motion, Group::motion, "", true, "", kCodes},
    {'G', 810, cycle, Group::motion, "", true, "", kCodes},
    {'G', 820, cycle, Group::motion, "", true, "", kCodes},
    {'G', 830, cycle, Group::motion, "", true, "", kCodes},
    {'G', 840, cycle, Group::motion, "", true, "", kCodes},
    {'G', 850, cycle, Group::motion, "", true, "", kCodes},
    {'G', 860, cycle, Group::motion, "", true, "", kCodes},
    {'G', 890, cycle, Group::motion, "", true, "", kCodes},
    {'G', 900, absolute, Group::distance, "", true, "", kCodes},
    {'G', 901, centre_absolute, Group::centre, "", true, "", kCodes},
    {'G', 910, incremental, Group::distance, "", true, "", kCodes},
    {'G', 911, centre_incremental, Group::centre, "", true, "", kCodes},
    {'G', 930, feed_inverse, Group::feed_mode, "", true, "", kCodes},
    {'G', 940, feed_per_minute, Group::feed_mode, "", true, "", kCodes},
    {'G', 950, feed_per_revolution, Group::feed_mode, "", true, "", kCodes},
    {'G', 970, harmless, Group::none, "", true, "", kCodes},
    {'G', 980, cycle_to_start, Group::cycle_return, "", true, "", kCodes},
    {'G', 990, cycle_to_plane, Group::cycle_return, "", true, "", kCodes},
    {'M', 0, harmless, Group::none, "", true, "", kOther},
    {'M', 10, harmless, Group::none, "", true, "", kOther},
    {'M', 20, program_end, Group::none, "", false, "", kOther},
    {'M', 30, spindle_on, Group::none, "$", true, "", kOther},
    {'M', 40, spindle_on, Group::none, "$", true, "", kOther},
    {'M', 50, spindle_off, Group::none, "$", true, "", kOther},
    {'M', 60, tool_change, Group::none, "", false, "", kOther},
    {'M', 70, harmless, Group::none, "", true, "", kOther},
    {'M', 80, harmless, Group::none, "", true, "", kOther},
    {'M', 90, harmless, Group::none, "", true, "", kOther},
    {'M', 300, program_end, Group::none, "", false, "", kOther},
    {'M', 480, harmless, Group::none, "", true, "", kOther},
    {'M', 490, harmless, Group::none, "", true, "", kOther},
    {'M', 4280, tip_control_on, Group::none, "", false, "", kKinematics},
    {'M', 4290, tip_control_off, Group::none, "", false, "", kKinematics},
});

constexpr auto kLinuxcncCycles = std::to_array<GcodeCycle>({
    {730, DrillForm::feed_in_rapid_out, "QL", kCodes},
    {810, DrillForm::feed_in_rapid_out, "L", kCodes},
    {820, DrillForm::feed_in_rapid_out, "PL", kCodes},
    {830, DrillForm::feed_in_rapid_out, "QL", kCodes},
    {840, DrillForm::thread, "PL", kCodes},
    {850, DrillForm::feed_in_feed_out, "L", kCodes},
    {860, DrillForm::feed_in_rapid_out, "PL", kCodes},
    {890, DrillForm::feed_in_feed_out, "PL", kCodes},
});

}  // namespace

const ControlTable& linuxcnc_table() {
  static const ControlTable table = {
      .id = "linuxcnc",
      .title = "LinuxCNC",
      .syntax = {.numbers = NumberRule::plain,
                 .has_semicolon_comments = true,
                 .has_o_words = true,
                 .has_named_variables = true,
                 .has_equal_tolerance = true,
                 .first_system_variable = 5001},
      .rows = kLinuxcncRows,
      .cycles = kLinuxcncCycles,
      .always = "FST",
      .start = "G17 G40 G49 G54 G64 G80 G90 G91.1 G94",
      .rounds_steps = false,
      .cycles_follow_mode = true,
      .cycles_count_from_start = false,
      .has_default_length = true,
      .turns = RotaryTurns::as_programmed,
      .has_tip_frame_of_table = true,
      .shifts_words_of_joints = true,
      .has_straight_rapids = true,
      .turns_along_arcs = true,
      .source = "LinuxCNC, G-Code Reference; src/emc/rs274ngc/interp_convert.cc and emccanon.cc: state after a reset",
  };
  return table;
}

}  // namespace gouge
