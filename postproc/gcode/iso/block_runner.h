#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/units.h"
#include "postproc/gcode/iso/block_words.h"
#include "postproc/gcode/running/arc_words.h"
#include "postproc/gcode/running/program_language.h"
#include "postproc/gcode/running/step_rounding.h"

namespace gouge {

/// The block that follows another one.
struct NextBlock {
  enum class Kind : std::uint8_t { following, end, call_program, call_block, back };
  Kind kind = Kind::following;
  int target = 0;  ///< number of the program, or of the block
  int times = 1;
};

/// Modal values of a program that are not those of ProgramMotion. Empty: nothing states them.
struct GcodeModes {
  const GcodeRow* motion = nullptr;  ///< null: axis words need a code
  std::optional<PlaneAxes> plane;
  std::optional<bool> is_absolute;
  bool is_centre_absolute = false;
  std::optional<LengthUnit> unit;
  FeedUnit feed_unit = FeedUnit::per_minute;
  std::optional<double> feed;
  bool has_feed = false;  ///< F is stated and not 0, though it may not be known
  std::optional<bool> retracts_to_start;
  std::optional<int> next_tool;
  bool has_waiting_tool = false;  ///< another tool than the one in the spindle was made ready
};

/// A drilling cycle in force; coordinates of the program, mm.
struct DrillState {
  std::optional<double> r_mm, z_mm, feed;
  bool is_r_step = false, is_z_step = false;  ///< by G91
  std::string open;                           ///< why R and Z are not known; empty: they are
  double start_mm = 0;                        ///< level at which the cycle began
  int times = 1;                              ///< of the block
};

/// Carries out the blocks of a program of a control, one after another.
class BlockRunner {
 public:
  /// Both must outlive the object.
  BlockRunner(const CodeIndex& index, const ProgramInput& input);

  /// Carries out a block. A word that is not understood ends the knowledge of all that follows, with its line.
  NextBlock run(const GcodeBlock& block, std::size_t line);
  /// Ends the knowledge of all that follows, because of a word or statement in a line.
  void lose_rest(const std::string& reason, std::size_t line);

  /// Returns whether a block has the word that ends a program.
  [[nodiscard]] bool has_end(const GcodeBlock& block) const;

  [[nodiscard]] const GcodeModes& modes() const { return modes_; }
  [[nodiscard]] std::size_t unit_line() const { return unit_line_; }
  /// Returns whether a length stands before the unit.
  [[nodiscard]] bool has_assumed_unit() const { return has_assumed_unit_; }
  [[nodiscard]] std::size_t offset_line() const { return offset_line_; }
  /// Returns an error that no later block can cure: a rotary word without a machine.
  [[nodiscard]] const std::optional<Diagnostic>& error() const { return error_; }
  /// Returns why nothing may follow a block unseen: the step limit and such are the caller's.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

 private:
  struct Target {
    AxisPlace place;
    std::string open;  ///< why a coordinate is not known
  };

  void take_modes();
  void note_level_of_cycle(double before_mm);
  void take_tool();
  void take_code(const GcodeRow& row);
  void take_path_control(const GcodeRow& row);
  void take_blending(const GcodeRow& row);
  void take_lengths();
  void take_length(const GcodeRow& row);
  [[nodiscard]] bool states_place_of_z() const;
  void begin_tip_control(const GcodeRow& row);
  void settle_tip_frame(const GcodeRow& row, bool is_call);
  [[nodiscard]] std::string take_frame_at_call();
  [[nodiscard]] double angle_of_block(std::size_t rotary);
  void end_tip_control(const GcodeRow& row);
  void take_offset(const GcodeRow& row);
  void take_tilted_plane();
  void change_tool();
  void take_feed();
  void note_unknown_feed();
  [[nodiscard]] NextBlock take_flow();

  void move();
  [[nodiscard]] std::string why_cycle_open() const;
  [[nodiscard]] const GcodeRow* find_own_motion() const;
  void move_to_machine_place();
  void go_to_machine(MoveKind kind, const AxisPlace& to);
  void go_home(const GcodeRow& row);
  void end_length_by(const GcodeRow& row);
  void go_by(const GcodeRow& row);
  void go_round(const GcodeRow& row, const Target& to);
  void drill(const GcodeRow& row);
  void drill_at(const GcodeCycle& cycle, const Target& at, const Vec3& step_mm);
  /// Levels of one hole: at its start, of the retract plane, and of its bottom.
  struct DrillLevels {
    double start_mm, r_mm, bottom_mm;
  };
  [[nodiscard]] std::string why_end_unknown(const DrillLevels& levels);
  void leave_hole_open(const Target& at, const Vec3& end, const std::string& why_unknown);
  [[nodiscard]] std::optional<int> times_of_cycle() const;
  [[nodiscard]] int times_of_steps() const;

  [[nodiscard]] Target target();
  [[nodiscard]] bool is_turn_stated(std::size_t rotary, double degrees, double way_deg) const;
  [[nodiscard]] double number(char letter, double plain_increment_mm);
  [[nodiscard]] double length(char letter);
  [[nodiscard]] double increment_mm() const { return StepRounding::increment_mm(modes_.unit.value_or(LengthUnit::mm)); }
  /// Takes the word of an axis for the roundings of steps. Returns why its place is not known; empty: it is.
  [[nodiscard]] std::string round_step(std::size_t axis, char letter, double value, double increment);
  [[nodiscard]] double mm_per_unit() const { return mm_per(modes_.unit.value_or(LengthUnit::mm)); }
  [[nodiscard]] std::string why_angle_open(std::size_t rotary, double angle_rad) const;
  void set_feed();

  const CodeIndex& index_;
  const ProgramInput& input_;
  const ProgramSetup& setup_;
  ProgramMotion& motion_;
  Toolpath& path_;
  BlockWords words_;
  GcodeModes modes_;
  DrillState cycle_;
  StepRounding rounding_;
  std::optional<Diagnostic> error_;
  std::string lost_;  // why a number of the block is not known
  bool has_noted_feed_ = false;
  std::size_t line_ = 0, unit_line_ = 0, offset_line_ = 0, lost_line_ = kNone;
  bool has_ended_ = false, has_assumed_unit_ = false;
};

}  // namespace gouge
