#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "lib/base/units.h"
#include "postproc/gcode/running/arc_words.h"
#include "postproc/gcode/running/program_language.h"
#include "postproc/gcode/running/step_rounding.h"
#include "postproc/gcode/siemens/siemens_words.h"

namespace gouge {

/// The way from a block to the next one.
struct SiemensNext {
  enum class Kind : std::uint8_t { following, end, back, call };
  Kind kind = Kind::following;
  std::string program;  ///< that is called
  int times = 1;
};

/// The blending of one block into the next by the control.
struct SiemensBlending {
  enum class Mode : std::uint8_t { not_stated, exact, free, distance, tolerance, cycle };
  Mode mode = Mode::not_stated;
  bool is_compressed = false;
  std::string compressor;                       ///< its word and line
  std::string word = "the state at the start";  ///< that states it
  double distance_mm = kUnknownValue;           ///< ADIS
  double rapid_distance_mm = kUnknownValue;     ///< ADISPOS
  double turn_deg = kUnknownValue;              ///< OTOL
  double tolerance_mm = kUnknownValue;          ///< CTOL, or the first argument of CYCLE832

  /// Returns the word that lets the tool leave its path, with its line.
  [[nodiscard]] const std::string& cause() const { return mode == Mode::exact ? compressor : word; }
};

/// Modal values of a program that are not those of ProgramMotion. Empty: nothing states them.
struct SiemensModes {
  const SiemensRow* motion = nullptr;
  std::optional<PlaneAxes> plane;
  std::optional<bool> is_absolute;
  std::optional<LengthUnit> unit;
  bool has_places_without_unit = false;
  FeedUnit feed_unit = FeedUnit::per_minute;
  std::optional<double> feed;
  SiemensBlending blending;
  const SiemensRow* turn_frame = nullptr;
  const SiemensRow* turn_path = nullptr;
  const SiemensRow* rapid_kind = nullptr;
  std::optional<ProgramFrame> frame;  ///< by TRANS, ROT, SCALE and MIRROR
  std::string open_frame;             ///< why it is not known; empty: it is
  std::string open_swivel;            ///< why the frame of CYCLE800 is not known; empty: it is
  bool has_swivel = false;
  bool has_vector = false;  ///< A3, B3 or C3 has turned the tool
  bool is_offset_stated = false;
  int edge = 0;  ///< of D; above 0: a length is applied
  std::string open_length = "nothing states D before this block; expected --start D1 or D0";
  std::optional<SiemensWord> next_tool;
  std::optional<SiemensWord> modal_cycle;  ///< of MCALL
  std::string open_modal_cycle;            ///< why its arguments are not known any more; empty: they are
  std::array<bool, 2> is_turn_open{};      ///< of rotary joints: DC, ACP or ACN took them beyond a turn, counted or not
  StepRounding rounding;
  Vec3 is_moved = Vec3::Zero();  ///< 1: the frame or the length changed after the last absolute word of the axis
};

/// Carries out the blocks of a Siemens program, one after another.
/// Source   docs/formats/gcode_siemens.md, word by word.
class SiemensRunner {
 public:
  /// `input` must outlive the object. `changes_tool_by_m6`: T only prepares the tool.
  SiemensRunner(const ProgramInput& input, bool changes_tool_by_m6);

  /// Carries out a block without a statement of program flow. A word that is not understood ends the knowledge of all that
  /// follows, with its line.
  SiemensNext run(const SiemensBlock& block, std::size_t line);
  void lose_rest(const std::string& reason, std::size_t line);
  /// States that a variable, such as R1, has another value from here on.
  void note_change(const std::string& variable, std::size_t line);

  [[nodiscard]] std::size_t unit_line() const { return unit_line_; }
  [[nodiscard]] const std::string& unit_word() const { return unit_word_; }
  [[nodiscard]] std::size_t offset_line() const { return offset_line_; }
  /// Returns the line of the first T that is taken to load its tool without M6; 0: none.
  [[nodiscard]] std::size_t loading_line() const { return loading_line_; }
  /// Returns an error that no later block can cure: a rotary word without a machine.
  [[nodiscard]] const std::optional<Diagnostic>& error() const { return error_; }

 private:
  struct Target {
    AxisPlace place;
    std::string open;  ///< why a coordinate, or the way to it, is not known
  };

  void take_codes();
  void take_mode(const SiemensWords::Code& code);
  void take_unit(LengthUnit unit, const std::string& word);
  void take_feed();
  void set_feed();
  void take_spindle(bool is_dwell);
  void take_offset(const std::string& name);
  void take_length_and_tool();
  void take_length(const SiemensWord& word);
  void change_tool();
  void take_transformation(const SiemensWords::Code& code);
  // Departure from the programmed path.
  void take_blending();
  void take_smoothing_cycle(const SiemensWord& cycle);
  void settle_path();
  [[nodiscard]] double path_bound() const;
  [[nodiscard]] std::string why_path_open() const;
  [[nodiscard]] std::string why_turn_rounded() const;
  [[nodiscard]] std::string why_turn_open() const;
  // Frames.
  void take_frame(const SiemensWords::Code& code);
  [[nodiscard]] std::optional<ProgramFrame> stated_frame(const SiemensRow& row);
  void take_swivel(const SiemensWord& cycle);
  [[nodiscard]] std::string set_swivel(const SiemensWord& cycle);
  void settle_frame();
  [[nodiscard]] std::string why_frame_open() const;
  // Motions.
  [[nodiscard]] SiemensNext take_flow();
  void move();
  void go(MoveKind kind, const Target& to);
  [[nodiscard]] Target target();
  void place_axes(Target& to);
  void place_rotaries(Target& to);
  [[nodiscard]] double increment_mm() const { return StepRounding::increment_mm(modes_.unit.value_or(LengthUnit::mm)); }
  /// Takes the word of an axis for the roundings of steps. Returns why its place is not known; empty: it is.
  [[nodiscard]] std::string round_step(std::size_t axis, const SiemensWord& word, double value, double increment);
  void place_vector(Target& to);
  void settle_turn(const SiemensWord& word, std::size_t rotary, double before, double angle, Target& to);
  [[nodiscard]] double turned(const SiemensWord& word, std::size_t rotary, Target& to) const;
  [[nodiscard]] std::string missing_fact() const;
  void move_to_target(MoveKind kind);
  void move_to_machine_axes(MoveKind kind, const SiemensWords::Code& code);
  void go_round(const SiemensRow& row, Target to);
  void go_by_point(const Target& to);
  [[nodiscard]] std::string read_opening_angle(ArcWords& arc, AxisPlace& end);
  // Cycles.
  void take_cycle();
  void drill(const SiemensWord& cycle);

  [[nodiscard]] double mm_per_unit() const;
  [[nodiscard]] double length(std::string_view address) const;
  [[nodiscard]] bool is_incremental(const SiemensWord& word) const;
  [[nodiscard]] std::string here(const std::string& what) const;

  const ProgramInput& input_;
  const ProgramSetup& setup_;
  ProgramMotion& motion_;
  bool changes_tool_by_m6_;
  SiemensWords words_;
  SiemensModes modes_;
  std::size_t line_ = 0, lost_line_ = std::numeric_limits<std::size_t>::max(), unit_line_ = 0, offset_line_ = 0,
              loading_line_ = 0;
  std::string unit_word_;
  std::optional<Diagnostic> error_;
};

/// Returns the value of an argument, or `absent` where it is left out; kUnknownValue: it is not known, or a text.
[[nodiscard]] double siemens_argument(const SiemensWord& word, std::size_t index, double absent);

}  // namespace gouge
