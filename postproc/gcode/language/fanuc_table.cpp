#include <array>

#include "postproc/gcode/language/control_tables.h"

namespace gouge {
namespace {

using enum GcodeMeaning;
using Group = ModalGroup;

constexpr std::string_view kFanucCodes =
    "Fanuc, B-64484EN (machining centre system), lists of G codes; A-79294E for G43.4";

// "When G53, G28, or G30 is specified in tool length offset mode, tool length offset vectors are canceled."
constexpr std::string_view kFanucHome = "Fanuc B-63844EN, 14.1.2: G53, G28 and G30 in tool length offset mode";

// Ascending by letter and number.
constexpr auto kFanucRows = std::to_array<GcodeRow>({
    {'G', 0, rapid, Group::motion, "", true, "", kFanucCodes},
    {'G', 10, feed, Group::motion, "", true, "", kFanucCodes},
    {'G', 20, arc_clockwise, Group::motion, "IJKR", true, "", kFanucCodes},
    {'G', 30, arc_counterclockwise, Group::motion, "IJKR", true, "", kFanucCodes},
    {'G', 40, harmless, Group::none, "PX", false, "", kFanucCodes},
    {'G', 51, blending, Group::path_control, "QR", false, "", kFanucCodes},
    {'G', 90, harmless, Group::none, "", true, "", kFanucCodes},
    {'G', 150, harmless, Group::none, "", true, "", kFanucCodes},
    {'G', 170, plane_xy, Group::plane, "", true, "", kFanucCodes},
    {'G', 180, plane_zx, Group::plane, "", true, "", kFanucCodes},
    {'G', 190, plane_yz, Group::plane, "", true, "", kFanucCodes},
    {'G', 200, inch, Group::unit, "", true, "", kFanucCodes},
    {'G', 210, mm, Group::unit, "", true, "", kFanucCodes},
    {'G', 280, home, Group::none, "", true, "", kFanucHome, true},
    {'G', 300, home, Group::none, "", true, "", kFanucHome, true},
    {'G', 400, harmless, Group::compensation, "", true, "", kFanucCodes},
    {'G', 410, not_checked, Group::compensation, "DH", true, "the path is compensated by the radius of the tool",
     kFanucCodes},
    {'G', 420, not_checked, Group::compensation, "DH", true, "the path is compensated by the radius of the tool",
     kFanucCodes},
    {'G', 430, length_on, Group::length, "H", true, "", kFanucCodes},
    {'G', 434, tip_control_on, Group::length, "HP", true, "", kFanucCodes},
    {'G', 435, not_checked, Group::length, "HIJKPQ", true,
     "G43.5 states vectors of the tool axis, and the parameters of the control choose the angles", kFanucCodes},
    {'G', 440, not_checked, Group::length, "H", true, "the length of the tool is applied the other way", kFanucCodes},
    {'G', 490, length_off, Group::length, "", true, "", kFanucCodes},
    {'G', 500, harmless, Group::none, "", true, "", kFanucCodes},
    {'G', 510, not_checked, Group::none, "IJKP", true, "later positions are scaled", kFanucCodes},
    {'G', 520, not_checked, Group::none, "", true, "the shift of later positions is not read", kFanucCodes},
    {'G', 530, machine_place, Group::none, "", true, "", kFanucHome, true},
    {'G', 531, align_to_plane, Group::none, "P", false, "", kFanucCodes},
    {'G', 540, work_offset, Group::work_offset, "", true, "", kFanucCodes},
    {'G', 541, work_offset, Group::work_offset, "P", true, "", kFanucCodes},
    {'G', 542, not_checked, Group::none, "P", true, "G54.2 shifts positions with the table by values of the control",
     kFanucCodes},
    {'G', 544, not_checked, Group::none, "P", true,
     "G54.4 corrects the setting of the workpiece by values of the control", kFanucCodes},
    {'G', 550, work_offset, Group::work_offset, "", true, "", kFanucCodes},
    {'G', 560, work_offset, Group::work_offset, "", true, "", kFanucCodes},
    {'G', 570, work_offset, Group::work_offset, "", true, "", kFanucCodes},
    {'G', 580, work_offset, Group::work_offset, "", true, "", kFanucCodes},
    {'G', 590, work_offset, Group::work_offset, "", true, "", kFanucCodes},
    {'G', 610, harmless, Group::path_control, "", true, "", kFanucCodes},
    {'G', 640, harmless, Group::path_control, "", true, "", kFanucCodes},
    {'G', 680, not_checked, Group::frame, "RIJK", true, "the frame is turned by G68", kFanucCodes},
    {'G', 682, tilted_plane, Group::frame, "XYZIJKPQR", true, "", kFanucCodes},
    {'G', 690, tilted_plane_off, Group::frame, "", true, "", kFanucCodes},
    {'G', 730, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 740, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 760, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 800, no_motion, Group::cycle_end, "", true, "", kFanucCodes},
    {'G', 810, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 820, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 830, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 840, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 850, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 860, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 870, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 880, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 890, cycle, Group::motion, "", true, "", kFanucCodes},
    {'G', 900, absolute, Group::distance, "", true, "", kFanucCodes},
    {'G', 910, incremental, Group::distance, "", true, "", kFanucCodes},
    {'G', 920, not_checked, Group::none, "", true, "the shift of later positions is not read", kFanucCodes},
    {'G', 930, feed_inverse, Group::feed_mode, "", true, "", kFanucCodes},
    {'G', 940, feed_per_minute, Group::feed_mode, "", true, "", kFanucCodes},
    {'G', 950, feed_per_revolution, Group::feed_mode, "", true, "", kFanucCodes},
    {'G', 970, harmless, Group::none, "", true, "", kFanucCodes},
    {'G', 980, cycle_to_start, Group::cycle_return, "", true, "", kFanucCodes},
    {'G', 990, cycle_to_plane, Group::cycle_return, "", true, "", kFanucCodes},
    {'M', 0, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 10, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 20, program_end, Group::none, "", false, "", kFanucCodes},
    {'M', 30, spindle_on, Group::none, "", true, "", kFanucCodes},
    {'M', 40, spindle_on, Group::none, "", true, "", kFanucCodes},
    {'M', 50, spindle_off, Group::none, "", true, "", kFanucCodes},
    {'M', 60, tool_change, Group::none, "", false, "", kFanucCodes},
    {'M', 70, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 80, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 90, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 190, spindle_off, Group::none, "", true, "", kFanucCodes},
    {'M', 300, program_end, Group::none, "", false, "", kFanucCodes},
    {'M', 480, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 490, harmless, Group::none, "", true, "", kFanucCodes},
    {'M', 980, call_program, Group::none, "PL", false, "", kFanucCodes},
    {'M', 990, return_from_call, Group::none, "", false, "", kFanucCodes},
});

constexpr auto kFanucCycles = std::to_array<GcodeCycle>({
    {730, DrillForm::feed_in_rapid_out, "QPK", kFanucCodes},
    {740, DrillForm::thread, "PQK", kFanucCodes},
    {760, DrillForm::not_checked, "PQIJK", kFanucCodes},
    {810, DrillForm::feed_in_rapid_out, "K", kFanucCodes},
    {820, DrillForm::feed_in_rapid_out, "PK", kFanucCodes},
    {830, DrillForm::feed_in_rapid_out, "QPK", kFanucCodes},
    {840, DrillForm::thread, "PQK", kFanucCodes},
    {850, DrillForm::feed_in_feed_out, "K", kFanucCodes},
    {860, DrillForm::feed_in_rapid_out, "PK", kFanucCodes},
    {870, DrillForm::not_checked, "PQIJK", kFanucCodes},
    {880, DrillForm::not_checked, "PK", kFanucCodes},
    {890, DrillForm::feed_in_feed_out, "PK", kFanucCodes},
});

}  // namespace

const ControlTable& fanuc_table() {
  static const ControlTable table = {
      .id = "fanuc",
      .title = "Fanuc",
      .syntax = {.numbers = NumberRule::by_point,
                 .has_semicolon_comments = false,
                 .has_macros = true,
                 .binds_and_as_times = true},
      .rows = kFanucRows,
      .cycles = kFanucCycles,
      .always = "FSTD",
      .start = "G54 G80",
      .length_motion = "parameter 5006#6 (TOS)",
      .turns = RotaryTurns::may_follow_sign,
      .takes_rapids_to_machine_places = true,  // B-64484EN, 7.1
      // B-64484EN, 4.1: nonlinear positioning is used by G53, and by G28 from the intermediate position.
      .goes_apart_to_machine = true,
      // The machine builder states the order of T and M6 in a block.
      .may_load_waiting_tool = true,
      // B-64124EN, 12.3: M98 P51002 calls O1002 five times. An option makes program numbers longer.
      .program_digits = 4,
      .source = kFanucCodes,
  };
  return table;
}

}  // namespace gouge
