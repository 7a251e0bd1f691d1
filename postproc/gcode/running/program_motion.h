#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "lib/path/joint_angles.h"
#include "postproc/gcode/running/axis_map.h"
#include "postproc/gcode/running/program_setup.h"
#include "postproc/program/motion_chain.h"
#include "postproc/program/path_builder.h"

// The motion of a program, independent of its language: the readers of all controls state frames, lengths and targets here,
// and this makes the moves of the path.

namespace gouge {

/// Coordinates of a program at one position: mm, and rad of the rotary joints of the machine, that nearer to the part
/// first. Unknown where they are not numbers.
struct AxisPlace {
  Vec3 xyz = Vec3::Constant(kUnknownCoordinate);
  RotaryAngles angles{kUnknownCoordinate, kUnknownCoordinate};
  std::optional<Vec3> axis;  ///< tool axis in the part, where the program states it in place of the angles

  static constexpr double kUnknownCoordinate = std::numeric_limits<double>::quiet_NaN();
};

/// A circle or helix in coordinates of the program.
struct ProgramArc {
  Vec3 centre = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double sweep_rad = 0;       ///< right-handed about `axis`, above 0
};

/// Reasons for which later motions cannot be checked. Each kind ends apart.
enum class ProgramDoubt : std::uint8_t {
  rest,          ///< a word that is not understood: nothing after it is known
  compensation,  ///< radius compensation
  frame,         ///< a frame of the program whose place is not known
  offset,        ///< a work offset whose value is not given
  length,        ///< a tool length whose value is not given
  tip_control,   ///< tool centre point control by a rule that is not known, or not that of the check
  path_control   ///< the control may leave the path by an unknown distance
};
inline constexpr std::size_t kProgramDoubts = 7;

class ProgramMotion {
 public:
  /// All must outlive the object.
  ProgramMotion(PathBuilder& builder, const ProgramSetup& setup);

  /// Begins a block: its statement and line are those of later moves.
  void begin_block(std::size_t statement, std::size_t line) {
    statement_ = statement;
    line_ = line;
    if (line > 0) has_run_[statement] = true;
  }
  /// Notes that the statements [first, last) are lines of a block that ran, or mark the end of the program.
  void note_run(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) has_run_[i] = true;
  }
  /// Returns which statements are part of a block that ran.
  [[nodiscard]] const std::vector<bool>& has_run() const { return has_run_; }

  // Facts that hold from here on.

  /// Chooses the work offset by its name. Two offsets need both values.
  void choose_offset(const std::string& name);
  void set_tip_control(TipControl control);
  /// Lets the coordinates of tool centre point control be those of the work offset with the joints at these angles, rad.
  void set_tip_frame(const RotaryAngles& angles);
  /// Sets the tilted frame, in the coordinates of the work offset; none: ends it.
  void set_plane(const std::optional<RigidTransform>& plane);
  /// Sets the frame of the program, in the coordinates of the tilted frame or of the work offset; none: ends it.
  void set_frame(const std::optional<ProgramFrame>& frame);
  /// Aligns the tool axis with the tilted frame. The motion to it is not checked. Later angles are not known.
  void align_to_plane();
  /// Loads a tool. Where the machine is afterwards is not known.
  void change_tool(const PathTool& tool);
  /// Applies the length of H; none: that of the tool in the spindle.
  void apply_length(std::optional<int> h);
  void cancel_length();
  /// Returns the number of the length that is applied, 0 without one; none: it is not known.
  [[nodiscard]] std::optional<int> applied_length() const {
    if (length_ == Length::none) return 0;
    return lost_length_.empty() ? length_number_ : std::nullopt;
  }
  /// Makes the length that is applied doubtful until another code states it; nothing is changed where none is applied.
  void lose_length(const std::string& reason);
  /// Runs a motion to places of the machine, for which it does not matter whether a length is applied.
  void run_by_machine(const std::function<void()>& run);
  /// Rapids without tool centre point control run straight on this control.
  void run_rapids_together() { are_rapids_together_ = true; }
  /// The program never applies a length: the work offset includes that of the first tool.
  void omit_lengths() { has_lengths_ = false; }
  void set_feed(const Feed& feed) {
    feed_ = feed;
    moves_per_minute_.reset();
  }
  /// Sets the speed of the spindle, in revolutions per minute. At 0 it stands; NaN: not known.
  void set_spindle(double rpm) {
    spindle_rpm_ = rpm > 0 ? static_cast<float>(rpm) : 0;
    is_speed_zero_ = std::abs(rpm) <= 0;
  }
  /// Stops the spindle before the next motion, or starts it.
  void stop_spindle(bool is_stopped) { is_spindle_stopped_ = is_stopped; }
  /// Sets the feed by the number of such motions in a minute (G93). Each move takes its length in that time.
  void set_inverse_time(std::optional<double> moves_per_minute) {
    feed_ = {};
    moves_per_minute_ = moves_per_minute;
  }
  void name_operation(std::string name) { operation_.name(std::move(name), line_); }
  /// Begins a doubt, with a reason for the user; a rest of the program that is not known keeps its first reason.
  void doubt(ProgramDoubt kind, std::string reason);
  void end_doubt(ProgramDoubt kind);
  /// Leaves moves unchecked from the first turn of a rotary joint on, until it is called with an empty reason.
  void doubt_turns(std::string reason) { turn_doubt_ = std::move(reason); }
  [[nodiscard]] bool has_doubt(ProgramDoubt kind) const { return !doubts_.at(static_cast<std::size_t>(kind)).empty(); }
  [[nodiscard]] bool is_rest_unknown() const { return !doubts_[0].empty(); }

  // Motions.

  /// Returns the last coordinates, in the frame that is in force.
  [[nodiscard]] const AxisPlace& place() const { return place_; }
  /// Returns the coordinates of the program at a place of the machine; unknown: the work offset is not given.
  [[nodiscard]] Vec3 from_machine(const Vec3& machine_mm) const;
  /// Returns the coordinates of the program where the axes of the machine, with the length that is applied, stand at these
  /// values. An axis that is not known keeps its place. Unknown: the work offset is not given, or tool centre point control
  /// or a tilted frame is in force.
  [[nodiscard]] Vec3 from_machine_axes(const Vec3& axes_mm) const;
  /// Returns whether the place of the machine's zero is given for the work offset in force.
  [[nodiscard]] bool is_offset_given() const;
  /// Returns a direction of the program in the part; none: the frame in force distorts it, or is not known.
  [[nodiscard]] std::optional<Vec3> direction_in_part(const Vec3& direction);
  /// Returns whether the work offset turns a rotary joint.
  [[nodiscard]] bool has_turned_offset() const;
  /// Returns the angle of a joint, in rad, that the block which runs states.
  [[nodiscard]] double angle_from_program(std::size_t rotary, double degrees);
  /// Notes that the block which runs states the angle of a joint without the work offset.
  void note_angle_of_machine(std::size_t rotary) { is_angle_of_machine_.at(rotary) = true; }
  [[nodiscard]] TipControl tip_control() const { return state_.tip_control; }
  [[nodiscard]] const RotaryAngles& tip_frame() const { return state_.tip_frame; }
  [[nodiscard]] const AxisMapper& mapper() const { return mapper_; }

  /// A block moves by steps from a place that is not known, so the height of the tool is not that of the tool change.
  void note_unknown_step() { has_unknown_step_ = true; }
  void go(MoveKind kind, const AxisPlace& to);
  void go_round(const AxisPlace& to, const ProgramArc& arc);
  /// Moves to a place of which only some coordinates are known, with the reason. The move is not checked.
  void go_unchecked(MoveKind kind, const AxisPlace& to, const std::string& reason);

  /// Stores the angles with the path, and notes. Must be called once, at the end.
  void finish();
  /// Work offset of the part: the first that the program chooses.
  [[nodiscard]] const std::string& part_offset() const { return part_offset_; }
  [[nodiscard]] bool has_lengths() const { return has_lengths_; }
  /// Returns the line from which places are right only if a length of 0 is in the work offset; 0: there is none.
  [[nodiscard]] std::size_t length_needed_line() const { return length_needed_line_; }
  [[nodiscard]] std::size_t tools_loaded() const { return tools_loaded_; }
  /// Rapids at the height of the start or of a tool change, of which nothing is swept.
  [[nodiscard]] const Tally& approach() const { return approach_; }

 private:
  /// Where a motion ends, or why that is not known.
  struct Reached {
    Pose pose;
    std::string open;
  };

  [[nodiscard]] const AxisMap& map_at(const RotaryAngles& angles);
  [[nodiscard]] const AxisMap& map_at(const AxisPlace& place);
  [[nodiscard]] Reached reached(const AxisPlace& to);
  [[nodiscard]] const std::string* first_doubt() const;
  [[nodiscard]] std::string why_not_motion(MoveKind kind, const AxisPlace& to, bool is_arc) const;
  template <typename Change>
  void change_state(const Change& change);
  void move_part_to(const std::string& name);
  void settle_length();
  [[nodiscard]] std::string why_sideways() const;
  void add(Move& move, const AxisPlace& to, const Reached& reached, std::string reason);
  [[nodiscard]] bool has_axis(const AxisPlace& to) const;
  [[nodiscard]] bool is_approach(MoveKind kind, const AxisPlace& to) const;
  void note_turn(const AxisPlace& to);
  /// Returns the law of the check under tool centre point control; none: no law is stated, or it is not on.
  [[nodiscard]] std::optional<TurnLaw> law_of_tip_control(MoveKind kind) const;
  [[nodiscard]] bool runs_without_tip_control(MoveKind kind) const;
  [[nodiscard]] bool turns_beyond_law(MoveKind kind, const AxisPlace& to) const;
  void leave_out(const AxisPlace& to);
  void note_height(const AxisPlace& to);
  void note_height_of_change(const PathTool& next);
  void take_table(PathTool& tool) const;
  [[nodiscard]] std::optional<int> tool_number() const;
  [[nodiscard]] std::optional<double> length_of(std::optional<int> number) const;
  /// Returns the length of a tool from the gauge point to the tip; none: it is not known.
  [[nodiscard]] std::optional<double> gauge_length_of(std::optional<int> number) const;
  /// Returns the reason why that length of the loaded tool is not known, and what is expected.
  [[nodiscard]] std::string why_no_gauge_length() const;
  void store_angles(const Move& move, const AxisPlace& to);

  PathBuilder& builder_;
  const ProgramSetup& setup_;
  AxisMapper mapper_;
  MotionChain chain_;
  OperationState operation_;
  AxisFrame state_;
  AxisPlace place_;
  AxisMap map_;  // of the state, with map_angles_
  RotaryAngles map_angles_{};
  bool is_map_current_ = false;
  std::array<std::string, kProgramDoubts> doubts_;
  std::string turn_doubt_;
  bool has_turned_ = false;  // a rotary joint has turned in a move
  Feed feed_;
  float spindle_rpm_ = 0;
  bool is_spindle_stopped_ = false, is_speed_zero_ = false;
  std::optional<double> moves_per_minute_;
  std::size_t statement_ = 0, line_ = 0, tool_ = kNone;
  std::vector<bool> has_run_;  // one for each statement
  std::string part_offset_, offset_name_;
  RotaryAngles angle_shift_{};  // of the work offset, rad
  bool has_lengths_ = true;
  std::size_t length_needed_line_ = 0;
  enum class Length : std::uint8_t { none, applied } length_ = Length::none;
  std::optional<int> length_number_;        // of H; none: of the tool
  std::optional<int> first_length_number_;  // of the first H that is applied to a tool without a number
  std::string lost_length_;                 // why the length that was applied may be in force no more; empty: it is
  std::size_t tools_loaded_ = 0;
  std::size_t length_tool_ = kNone;  // tool in the spindle when the length was applied
  bool are_rapids_together_ = false, has_unknown_step_ = false;
  std::string lost_place_;   // why coordinates before the first place are not known; empty: none is stated
  std::string lost_angles_;  // why the angles of rotary joints are not known any more; empty: none is lost
  std::array<bool, 2> is_angle_of_machine_{};  // of rotary joints: stated at the start, or as places of the machine
  std::shared_ptr<JointPath> joints_;
  Tally approach_, unknown_angles_;
};

}  // namespace gouge
