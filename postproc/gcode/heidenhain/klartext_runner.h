#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "postproc/gcode/heidenhain/klartext_block.h"
#include "postproc/gcode/heidenhain/klartext_frame.h"
#include "postproc/gcode/heidenhain/path_words.h"
#include "postproc/gcode/heidenhain/q_parameters.h"
#include "postproc/gcode/running/arc_words.h"
#include "postproc/gcode/running/program_language.h"
#include "postproc/gcode/running/step_rounding.h"

namespace gouge {

/// A cycle that runs when it is called, with its Q parameters.
struct KlartextCycleCall {
  const KlartextCycle* row = nullptr;  ///< null: none is defined
  std::map<int, double> parameters;
};

/// Carries out the blocks of a Klartext program that do not change the order of blocks.
class KlartextRunner {
 public:
  /// Both must outlive the object.
  KlartextRunner(const ProgramInput& input, QParameters& parameters);

  /// Begins a block: its line is that of messages.
  void begin_line(std::size_t line) { line_ = line; }
  /// Carries out a block. A word that is not understood ends the knowledge of all that follows, with its line.
  /// `is_cut`: a block follows that rounds or chamfers the end of this motion.
  void run(const KlartextBlock& block, std::size_t line, bool is_cut);
  /// Ends the knowledge of all that follows, because of a word or statement in a line.
  void lose_rest(const std::string& reason);

  [[nodiscard]] bool has_ended() const { return has_ended_; }
  [[nodiscard]] const ProgramFacts& facts() const { return facts_; }
  /// Notes motions that do not run; the first ones count.
  void note_other_program(OtherProgram other) {
    if (!facts_.other) facts_.other = std::move(other);
  }

 private:
  using Words = std::vector<KlartextWord>;
  /// The end of a motion: xyz in mm of the program, and why a coordinate is not known.
  struct Target {
    AxisPlace place;
    std::string open;
  };
  /// Unit, in the plane of X and Y of the program.
  struct Direction {
    double x = 0, y = 0;
  };
  /// Coordinates about the pole: mm and degrees.
  struct Polar {
    double radius = 0, angle = 0;
  };

  // Statements: klartext_runner.cpp.
  void run_statement(std::string_view text);
  [[nodiscard]] bool take_start_fact(std::string_view text);
  bool run_path_statement(std::string_view text);
  void note_moved_axes(const Vec3& before);
  void begin_program(std::string_view text);
  void end_program(std::string_view text);
  void call_tool(std::string_view text);
  void define_tool(std::string_view text);
  void define_radius(const PathTool& tool, double radius);
  void run_functions(std::string_view text);
  [[nodiscard]] bool read_words(std::string_view text, Words& words);
  [[nodiscard]] bool take_words(std::string_view text, const PathForm& form, PathWords& taken);
  void settle_length();
  void settle_path();

  // Frames: klartext_frames.cpp.
  void define_plane(std::string_view text);
  /// Begins a tilted plane by spatial angles; with a reason why they are not known.
  void tilt(const std::string& reason, const Vec3& angles_deg, std::string_view positioning);
  void end_tilt(std::string_view positioning);
  [[nodiscard]] std::string take_positioning(const Words& words, std::size_t first, std::string_view& found) const;
  void control_tip(std::string_view text);
  void begin_tip_control(const std::string& open);
  [[nodiscard]] std::string why_point_open() const;
  void end_tip_control();
  void switch_tip_control(TipControl control);
  void settle_frame();
  void end_shift();

  // Motions: klartext_motion.cpp and klartext_arcs.cpp.
  void go_line(const PathWords& words);
  void go_polar_line(const PathWords& words);
  void go_about_pole(const PathWords& words);
  void go_polar_arc(const PathWords& words);
  void go_by_radius(const PathWords& words);
  void go_tangentially(const PathWords& words, bool is_polar);
  void set_pole(const PathWords& words);
  void cut_corner(std::string_view text);
  void begin_motion(const PathWords& words);
  void end_motion(const PathWords& words);
  void take_feed(const PathWords& words);
  void set_feed();
  void run_block(const PathWords& words, const Target& to);
  void run_line(MoveKind kind, const Target& to);
  void run_read_arc(const PathWords& words, const ArcWords& arc, Target to);
  void run_arc(const PathWords& words, const ProgramArc& arc, const Target& to);
  void run_unchecked(MoveKind kind, const Target& to, const std::string& reason);
  [[nodiscard]] std::string why_corner_open() const;
  [[nodiscard]] Target target(const PathWords& words);
  [[nodiscard]] std::string round_step(std::size_t axis, const PathCoordinate& word, double unit,
                                       const std::string& name);
  [[nodiscard]] Target polar_target(const PathWords& words);
  void activate_rotation(const PathWords& words, Target& to);
  void aim_rotary(const PathWords& words, Target& to);
  void aim_joint(std::size_t rotary, const PathCoordinate& word, bool is_of_machine, Target& to);
  void align_with_plane(const PathWords& words, Target& to);
  void aim_at_machine_place(const PathWords& words, Target& to);
  void retract();
  [[nodiscard]] Vec3 place() const { return frame_.inside(motion_.place().xyz); }
  [[nodiscard]] double length(double value) const { return value * mm_per(unit_); }

  // Cycles: klartext_cycles.cpp.
  void define_cycle(std::string_view text);
  void define_step(int cycle, int step, std::string_view text);
  void define_shift(const Words& words);
  void define_value(int cycle, const Words& words);
  void define_mirror(const Words& words);
  void define_working_plane(const Words& words);
  void define_tolerance(int step, const Words& words);
  void define_parameters(int cycle, std::string_view text);
  void call_cycle(std::string_view text);
  void drill();
  [[nodiscard]] std::string why_not_drilled() const;
  void choose_preset(std::optional<int> number);

  const ProgramInput& input_;
  Words path_words_;  // memory that is used again
  const ProgramSetup& setup_;
  ProgramMotion& motion_;
  QParameters& parameters_;
  KlartextFrame frame_;
  KlartextCycleCall cycle_;
  ProgramFacts facts_;
  LengthUnit unit_ = LengthUnit::mm;
  // That TOOL DEF states, by name_of_tool.
  std::map<std::string, double> diameters_mm_, lengths_mm_;
  std::optional<double> feed_;
  bool is_per_revolution_ = false;
  std::optional<std::array<double, 2>> pole_;  // mm of the program
  std::optional<Direction> tangent_;           // at the end of the last motion
  std::optional<Polar> polar_;                 // of the last motion
  std::array<int, 2> step_{};                  // cycle and step that a numbered cycle has defined last; cycle 0: none
  bool needs_step_ = false;                    // a numbered cycle has no values yet
  bool takes_shortest_ = false;                // M126
  StepRounding rounding_;
  std::array<bool, 2> is_turn_open_{};  // of rotary joints: M126 may have left the count of turns or not
  std::size_t rotation_line_ = 0;       // of a rotation that is not active for both axes of the plane; 0: none
  std::array<bool, 3> is_moved_{};      // the frame changed after the last absolute coordinate of the axis
  bool has_several_lines_ = false;      // the block that runs
  bool has_preset_ = false;
  bool has_begun_ = false, has_ended_ = false;
  std::string head_;             // name and unit behind BEGIN PGM
  bool is_cut_ = false;          // a block follows that rounds the end of this motion
  bool was_cut_ = false;         // the last block was such a motion
  bool follows_corner_ = false;  // the last block has rounded a corner
  bool is_tilt_open_ = false;    // the rotary axes have not gone to the tilted plane yet
  bool has_tilt_ = false;
  bool are_cycle_angles_spatial_ = false;  // stated at the start: those of cycle 19
  bool are_points_of_tip_ = false;         // REFPNT TIP-TIP is stated at the start
  std::string length_open_, tip_open_, tolerance_open_, path_open_, tilt_open_;
  std::size_t line_ = 0;
};

}  // namespace gouge
