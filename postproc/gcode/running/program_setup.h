#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/machine/machine.h"

namespace gouge {

/// Value of Toolpath::dialect of every program. The joints of such a path are those that the program states.
inline constexpr std::string_view kProgramDialect = "gcode";

/// Length of a tool that has offsets of other axes than Z too. They are not read, so its tip is not known.
inline constexpr double kSidewaysLength = std::numeric_limits<double>::quiet_NaN();

/// Zero of a work offset in machine coordinates, with all joints at 0: mm, and degrees of A, B and C.
struct WorkOffset {
  Vec3 xyz_mm = Vec3::Zero(), abc_deg = Vec3::Zero();
};

/// Value of a number without a decimal point on controls where a parameter states it.
enum class PlainNumbers : std::uint8_t {
  not_stated,
  units,      ///< X100 is 100 mm, inches or degrees
  increments  ///< X100 is 100 increments of 0.001 mm, 0.0001 inches or 0.001 degrees
};

/// Coordinates that tool centre point control follows on machines whose table turns, where a parameter states it.
enum class TipFrame : std::uint8_t {
  not_stated,
  table,          ///< they turn with the table, which is at 0 where the control begins
  table_at_zero,  ///< they turn with the table, and are those of the work offset with the table at 0
  table_at_call,  ///< they turn with the table, and are those of the work offset where the control begins
  workpiece       ///< they stand while the table turns
};

/// A tool table of a control: facts about each tool by its number.
struct ToolTable {
  std::string file;                    ///< of the table
  std::map<int, double> lengths_mm;    ///< NaN: kSidewaysLength
  std::map<int, double> diameters_mm;  ///< of tools for which the table states one
  std::map<int, double> corners_mm;    ///< corner radii, likewise
};

/// Facts about a program that are not in its file. What is absent is not known, and never zero.
struct ProgramSetup {
  std::string control;                        ///< id of a ControlTable; empty: that of the machine's control
  bool is_control_stated = false;             ///< an option states `control`
  bool is_control_of_program = false;         ///< the program itself shows `control`
  std::shared_ptr<const Machine> machine;     ///< null: a program without rotary words
  std::optional<RigidTransform> zero;         ///< maps part coordinates to machine coordinates
  std::map<std::string, WorkOffset> offsets;  ///< by name: "G54", "G54.1P3"
  std::map<int, double> lengths_mm;           ///< length of each tool by its number, and of H; NaN: kSidewaysLength
  std::map<int, double> diameters_mm;         ///< of tools by their numbers, to be compared with those of a library
  std::map<int, double> corners_mm;           ///< corner radii, likewise
  std::string tool_table;                     ///< the file that states them
  std::optional<double> tool_length_mm;       ///< of every tool
  std::string start;                          ///< blocks in force at the start, in the language of the control
  std::vector<std::string> tip_control_ends;  ///< codes that end tool centre point control: "G255"
  std::optional<bool> is_block_delete_on;     ///< blocks with a slash are left out
  std::optional<double> tip_tolerance_mm;     ///< the check covers this distance of the tip from its path
  std::optional<double> axis_tolerance_rad;   ///< the check covers this angle of the tool axis from its law
  bool are_joint_rapids_straight = false;     ///< rapids without tool centre point control run evenly
  std::optional<TurnLaws> laws;               ///< by which the tool turns in the check; none: vector
  std::optional<bool> winds_as_programmed;    ///< an absolute rotary word states the turn; none: as the control does
  TipFrame tip_frame = TipFrame::not_stated;
  std::optional<TurnLaw> feed_law;  ///< by which the check moves feeds with tool centre point control
  PlainNumbers plain_numbers = PlainNumbers::not_stated;
  std::optional<Vec3> home_mm;  ///< of X, Y and Z, in machine coordinates
  /// Returns the texts of the files beside the program that a call by this name may mean. Empty: none is looked for.
  std::function<std::vector<std::string>(const std::string& name)> read_beside = {};
};

}  // namespace gouge
