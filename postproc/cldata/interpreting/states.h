#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/letters.h"
#include "lib/base/units.h"
#include "postproc/cldata/interpreting/arc_senses.h"
#include "postproc/cldata/interpreting/axis_state.h"
#include "postproc/cldata/interpreting/block_state.h"
#include "postproc/cldata/interpreting/catia_matrix.h"
#include "postproc/cldata/interpreting/clt_setup.h"
#include "postproc/cldata/interpreting/control_modes.h"
#include "postproc/cldata/interpreting/control_motion.h"
#include "postproc/cldata/interpreting/cutter_compensation.h"
#include "postproc/cldata/interpreting/cycle_state.h"
#include "postproc/cldata/interpreting/described_curve.h"
#include "postproc/cldata/interpreting/feed_units.h"
#include "postproc/cldata/interpreting/frame_state.h"
#include "postproc/cldata/interpreting/nurbs_state.h"
#include "postproc/cldata/interpreting/part_program.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/tool_state.h"
#include "postproc/cldata/interpreting/uncertainties.h"
#include "postproc/cldata/parsing/feed_statement.h"
#include "postproc/cldata/parsing/spindle_statement.h"
#include "postproc/program/motion_chain.h"

namespace gouge {

/// FEDRAT and SPINDL, which hold until the next one, and RAPID, which holds for one motion. If no motion follows, they
/// have no effect.
class FeedState {
 public:
  explicit FeedState(StatementContext& in) : in_(in) {}

  // Takes a FEDRAT. After a feed per revolution, a feed without a unit is ambiguous: no file states its kind.
  void take_fedrat(double mm_per_unit) {
    if (switches_inverse_time(in_.arguments)) return;
    feed_ = read_feed(in_.arguments, mm_per_unit);
    if (has_feed_per_turn_ && !has_feed_unit(in_.arguments)) feed_ = {0, FeedUnit::not_understood};
    has_feed_per_turn_ = has_feed_per_turn_ || feed_.unit == FeedUnit::per_revolution;
  }
  void take_spindle() {
    spindle_rpm_ = read_spindle_speed(in_.arguments).value_or(spindle_rpm_);
    is_spindle_stopped_ = stops_spindle(in_.arguments).value_or(is_spindle_stopped_);
  }
  void stop_spindle(bool is_stopped) { is_spindle_stopped_ = is_stopped; }
  void begin_rapid() {
    end_rapid();
    is_rapid_ = true;
    rapid_statement_ = in_.index();
  }
  void end_rapid() { is_rapid_ = is_rapid_before_from_ = is_kind_doubtful_ = false; }
  /// Notes that the next motion is rapid in one reading of the file, and a feed in another one.
  void doubt_kind() { is_kind_doubtful_ = true; }
  /// Notes that the first position of the present statement is, or may be, in rapid. Its further ones may be, too.
  void note_rapid_position() { rapid_list_ = in_.index(); }
  /// Notes that a FROM, which is no motion, follows a RAPID.
  void keep_rapid_over_from() { is_rapid_before_from_ = true; }
  void begin_block() { feed_ = {}; }

  [[nodiscard]] const Feed& feed() const { return feed_; }
  [[nodiscard]] float spindle_rpm() const { return spindle_rpm_; }
  [[nodiscard]] bool is_spindle_stopped() const { return is_spindle_stopped_; }
  [[nodiscard]] bool is_rapid() const { return is_rapid_; }
  /// Returns whether the file leaves open whether a RAPID holds for the next position.
  [[nodiscard]] bool may_be_rapid() const {
    const bool goes_on = in_.statement().is_continuation && rapid_list_ + 1 == in_.index();
    return !is_rapid_ && (is_rapid_before_from_ || rapid_list_ == in_.index() || goes_on);
  }
  /// Returns whether a RAPID awaits its motion, surely or perhaps.
  [[nodiscard]] bool is_rapid_pending() const { return is_rapid_ || is_rapid_before_from_; }
  [[nodiscard]] bool is_kind_doubtful() const { return is_kind_doubtful_; }
  /// Returns whether the next motion is of the same kind as in `other`.
  [[nodiscard]] bool has_kind_of(const FeedState& other) const {
    return is_rapid_ == other.is_rapid_ && is_rapid_before_from_ == other.is_rapid_before_from_ &&
           is_kind_doubtful_ == other.is_kind_doubtful_;
  }
  /// Returns the last RAPID, or kNone.
  [[nodiscard]] std::size_t rapid_statement() const { return rapid_statement_; }

 private:
  StatementContext& in_;
  Feed feed_;
  float spindle_rpm_ = 0;
  bool is_spindle_stopped_ = false;
  bool has_feed_per_turn_ = false;  // a FEDRAT had this unit; then the unit of one without it is unknown
  bool is_rapid_ = false;
  bool is_rapid_before_from_ = false;
  bool is_kind_doubtful_ = false;
  std::size_t rapid_statement_ = kNone;
  std::size_t rapid_list_ = kNone;  // statement whose first position is, or may be, in rapid
};

/// Text for the control that may be the name that SolidWorks CAM gives to the next tool.
struct PendingInsert {
  std::size_t statement;
  bool is_name;
};

/// Moves that COPY may repeat.
struct IndexedMoves {
  std::size_t begin = 0, end = kNone;  ///< kNone: the range has no end yet
  std::size_t frames = 0;              ///< States::frame_changes at the beginning of the range
  bool is_border_open = false;         ///< a copy would begin in another state than the range
  bool begins_with_step = false;       ///< its first move is a step, which continues from elsewhere when it is repeated
};
inline constexpr std::size_t kMaxCopied = 1000000;  ///< maximum number of moves copied by one COPY

/// MOVNRB of Creo: a NURBS in statements of its own.
struct MovnrbState {
  std::size_t order = 0;
  bool is_five_axis = false;  ///< five-axis, or of a form that is not read
  std::vector<double> knots;
  std::vector<Vec3> control_local;
  bool is_on = false;       ///< positions on the curve follow
  std::size_t begin = 0;    ///< the move along the curve
  Vec3 end = Vec3::Zero();  ///< end of the curve, in part coordinates
};

inline constexpr double kUnknownSlope = std::numeric_limits<double>::infinity();

/// The states at OPSKIP/ON. They are those behind OPSKIP/OFF if the control leaves out the statements between.
struct BeforeSkip {
  const char* reason;         ///< names the OPSKIP
  std::optional<Pose> start;  ///< position of the tool, if it is known
  MotionChain chain;
  AxisState axes;
  FeedState feed;
  CutterCompensation cutcom;
  Uncertainties uncertainties;
  std::optional<double> clear_plane_mm, arc_slope_mm;
  std::size_t frame_changes = 0, block = 0;
};

/// All data that a statement may examine or change. The file of each state describes the case that the file never ends
/// it.
struct States {
  /// `motion_records` may be null; else it gets one entry for each move.
  States(Toolpath& path, const Dialect& dialect, LengthUnit unit, MotionRecords* motion_records)
      : in(path, dialect), records(motion_records), frame(in, mm_per(unit)) {}
  States(const States&) = delete;
  States& operator=(const States&) = delete;

  StatementContext in;
  MotionRecords* records;
  Uncertainties uncertainties;
  AxisState axes{in, uncertainties};
  FeedState feed{in};
  FeedUnits feed_units;
  ControlMotion control_motion;
  ControlModes control_modes;
  FrameState frame;
  BlockState blocks;
  CatiaMatrix matrix{in, frame};
  CltSetup setup{in, uncertainties};
  CutterCompensation cutcom{in};
  DescribedCurve curve{in};
  NurbsState nurbs{in, frame, axes};
  ArcSenses senses{in};
  CycleState cycle{in};
  ToolState tool{in, uncertainties};
  OperationState operation{in};
  MotionChain chain{in};
  PartProgram program{in};
  std::string work_offset;               ///< the work offset of the positions; empty: none is chosen
  Tally offsets_chosen;                  ///< work offsets chosen by text for the machine's control
  std::size_t smoothing_line = 0;        ///< first text for the control that lets it leave the path; 0: none
  double smoothing_mm = 0;               ///< the largest distance that such text states
  std::size_t joint_law_line = 0;        ///< first text by which the rotary joints run in proportion; 0: none
  bool is_unknown_in_block = false;      ///< the open block contains a statement that is not understood
  std::optional<PendingInsert> pending;  ///< text that is the name of a tool if a CUTTER follows
  bool is_world_stated = false;          ///< there was a TRNTYP/WORLD
  bool has_begin = false;                ///< there was a PARTNO
  std::size_t end_line = 0;              ///< line of the last END, FINI or END-OF-PATH; 0: none
  struct LastPositions {                 ///< the last statement with positions, and the one before it
    std::size_t statement = kNone;
    std::size_t numbers = 0, numbers_before = 0;  ///< for each position
    std::string_view last_number, number_before;  ///< text in the file
    bool has_plain = false;                       ///< a position without axis precedes the last one
  } last_positions;
  MovnrbState movnrb;
  std::map<int, IndexedMoves> indexed;  ///< by the number in INDEX
  std::size_t frame_changes = 0;
  bool is_frame_stated = false;            ///< by a word that set_frame serves
  std::optional<double> arc_slope_mm;      ///< rise of the next arc, by ARCSLP; kUnknownSlope: no arc has it
  std::optional<BeforeSkip> before_skip;   ///< states before the last OPSKIP/ON
  std::optional<Pose> skip_start;          ///< position before the skip that ended last, if both readings are known
  const char* skip_reason = nullptr;       ///< reason of the skip that ended last
  std::size_t skip_begin = 0;              ///< the first move after OPSKIP/ON
  bool is_behind_skip = false;             ///< no position since OPSKIP/OFF, and some between ON and OFF
  std::optional<double> clear_plane_mm;    ///< CLEARP: Z of a plane perpendicular to the axis, in the frame in force
  std::vector<Pose> open_places;           ///< places where the tool may be after a hole
  CapitalSet homed_axes;                   ///< axes that went home since the last position
  std::optional<Pose> retracted;           ///< position after RETRCT, until the next position
  bool skips_more_than_motion = false;     ///< between OPSKIP/ON and OFF there is a statement that OFF does not undo
  std::size_t run_begin = 0;               ///< the first move since the last tool or operation
  Word previous_word = Word::comment;      ///< word of the previous statement that is not a comment
  std::size_t previous_statement = kNone;  ///< that statement
};

}  // namespace gouge
