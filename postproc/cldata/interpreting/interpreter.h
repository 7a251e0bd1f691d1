#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/geom/rigid_transform.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/interpreting/modal_states.h"
#include "postproc/cldata/interpreting/named_reasons.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/tally.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/cutcom.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/parsing/arc_statement.h"
#include "postproc/cldata/parsing/cycle_statement.h"
#include "postproc/cldata/parsing/machine_text.h"

// Statements to moves: the modal state of CL data. The reader runs it to fill a Toolpath; the writer runs it
// again over the same bytes to know in which state (axis, frame, unit, rapid) each position was read.

namespace gouge {

/// How a position is written, as far as a writer must know.
enum class PositionForm : std::uint8_t { go_to, from, gohome, godlta, curve, cycle, unread };

/// What makes a position's numbers a place: p = to_part(mm_per_unit x).
struct MotionFrame {
  double mm_per_unit = 1;
  RigidTransform to_part;
};

/// The state a move was read in.
struct MotionRecord {
  SmallIndex statement;
  SmallIndex point, points = 1;        ///< which of how many positions of its statement
  SmallIndex first_argument;           ///< of this position
  SmallIndex rapid_statement = kNone;  ///< the last RAPID before it
  SmallIndex block;                    ///< number of the TOOL PATH block; the modal axis does not cross blocks
  SmallIndex curve_statement = kNone;  ///< of an arc: what describes it besides its own statement
  std::uint8_t numbers = 0;  ///< 3 or 6, of the hole for a step of a cycle; 0 where the form is godlta, curve or unread
  PositionForm form = PositionForm::go_to;
  bool is_rapid = false;                    ///< by a RAPID before it
  CutcomSide cutcom = CutcomSide::none;
  bool is_tapping = false;                  ///< a step of a cycle whose spindle turns back
  bool is_multax_off = false;               ///< positions with an axis would be read as two, or not checked
  Vec3 axis_local = Vec3::UnitZ();          ///< axis of this position, in the block's frame
  Vec3 implied_axis_local = Vec3::UnitZ();  ///< what a position of 3 numbers means here
  const MotionFrame* frame = nullptr;       ///< one of MotionRecords::frames
};

struct MotionRecords {
  std::vector<MotionRecord> of_move;  ///< one for each of Toolpath::moves, in the same order
  std::deque<MotionFrame> frames;     ///< a deque, because records point into it while it grows
};

class Interpreter {
 public:
  /// `path.source` holds the bytes. `records` may be null; else it gets one entry for each move.
  Interpreter(Toolpath& path, const Dialect& dialect, LengthUnit unit, MotionRecords* records);

  /// Takes the next statement. Errors go to errors(); once is_hopeless(), reading further has no use.
  void take(const Statement& statement);
  /// To be called once, after the last statement.
  void finish();

  /// Positions under CUTCOM are the cutter's centre, because the user says so.
  void set_cutter_centre() { is_cutter_centre_ = is_cutter_centre_said_ = true; }

  [[nodiscard]] Diagnostics take_errors();
  [[nodiscard]] bool is_hopeless() const { return is_hopeless_; }

 private:
  struct Position {  // of one statement, before it becomes a move; file numbers made mm, in the block's frame
    Vec3 tip_local = Vec3::Zero();
    Vec3 axis_local = Vec3::UnitZ();
    std::size_t point = 0, points = 1, first_argument = 0, numbers = 0;
    PositionForm form = PositionForm::go_to;
  };
  struct CycleState {
    bool is_on = false;
    std::optional<DrillCycle> drill;  // nothing: not understood
    std::size_t line = 0;             // of the CYCLE in force
    std::size_t first_positions = kNone;  // the statement of its first position
    std::size_t certain_moves = 0;    // those before this one are certain whether or not the cycle ever ended
    bool is_contradicted = false;     // a later statement says that it should have ended
    std::size_t contradicted_moves = 0;  // read until then
    std::string_view reason;          // told of what it leaves doubtful
    // While none is in force: moves from here on could be holes of a cycle whose CYCLE is missing.
    std::size_t first_possible_hole = 0;
  };
  struct TableTurn {
    std::string_view axis;
    double angle = 0;  // counter-clockwise, as its file counts
  };
  struct ToolState {
    std::optional<int> number;
    std::optional<CutterStatement> cutter;
    std::string name;
    double flute_length_mm = 0;
    double diameter_mm = 0;  // of Creo, whose $$-> CUTTER says nothing else
    double toolno_diameter_mm = 0;  // behind the number of TOOLNO; 0 where none stands there
    std::size_t toolno_line = 0;
    std::size_t line = 0;
    bool is_fresh = false;  // defined since the last motion
  };

  /// `all` with room for `more`, or for as many as the rest of the file holds if it goes on like this: growing
  /// by doubling would need three times the memory while it copies.
  template <class Things>
  void make_room(Things& all, std::size_t more = 1) const {
    const std::size_t needed = all.size() + more;
    if (needed > all.capacity()) all.reserve(expected_count(needed));
  }
  [[nodiscard]] std::size_t expected_count(std::size_t until_here) const;

  void fail(std::string code, std::string message);
  void fail_too_long();
  void fail_run_on(std::string_view hidden);

  // interpret_assignment.cpp
  void refuse_part_program(std::string_view what);
  [[nodiscard]] bool take_assignment();
  void refuse_assignments();

  void count_unknown();
  [[nodiscard]] const char* because(const char* reason);

  // interpret_states.cpp
  void apply_modal_states(Word word);
  [[nodiscard]] bool is_open(ModalState state) const;
  [[nodiscard]] bool is_used(ModalState state) const;
  void end_state(ModalState state);
  void contradict(ModalState state);
  void drop_described_curve();
  void doubt_run(const char* reason, std::size_t& run_begin);
  void doubt_moves(std::size_t begin, std::size_t end, std::string_view reason);

  // interpret_unread.cpp
  void take_unknown();
  void emit_unread(const char* reason = Reasons::kUnread) { emit_unread(reason, path_.statements.size() - 1); }
  void emit_unread(const char* reason, std::size_t statement);
  [[nodiscard]] bool is_statement() const;
  void take_syn();
  [[nodiscard]] bool take_misread(std::string_view text);
  void take_rest_of_statement(bool is_position);
  void begin_block();
  void distrust_arguments();
  void distrust(Word word);
  void distrust_moves(std::size_t statement);
  void distrust_cut_short();

  // interpret_harmless.cpp
  void take_harmless();
  void distrust_numbers_of_feed();

  // interpret_machine_text.cpp
  void take_insert();
  void take_codes(char letter);
  void take_machine_text(const MachineEffect& effect);
  void take_setup();
  void take_select();

  [[nodiscard]] bool take_motion_word();
  [[nodiscard]] bool take_tool_word();
  [[nodiscard]] bool take_frame_word();
  [[nodiscard]] bool take_text_word();
  [[nodiscard]] bool take_unread_word();

  // interpret_motion.cpp
  void take_positions(PositionForm form);
  void take_godlta();
  [[nodiscard]] std::optional<Pose> godlta_start() const;
  void take_gohome();
  void take_rapid();
  void take_fedrat();
  void take_multax();
  void take_cutcom();
  void begin_cutcom();
  void end_cutcom();
  /// Under CUTCOM, and nothing says that positions are the cutter's centre.
  [[nodiscard]] bool is_compensated() const { return cutcom_ != CutcomSide::none && !is_cutter_centre_; }
  [[nodiscard]] std::string_view cutcom_reason() const;
  [[nodiscard]] std::size_t numbers_per_point();
  [[nodiscard]] bool check_all_numbers(std::string_view expected);
  [[nodiscard]] std::optional<Vec3> read_axis(std::size_t first);
  [[nodiscard]] std::optional<Vec3> read_tip(std::size_t first);
  [[nodiscard]] Vec3 implied_axis() const;
  void emit(const Position& position);
  [[nodiscard]] Move make_move(const Position& position, MoveKind kind);
  void append(Move move, const Position& position);
  [[nodiscard]] MotionRecord make_record(const Move& move, const Position& position);
  [[nodiscard]] bool has_doubtful_axis(const Position& position);
  [[nodiscard]] bool are_axes_doubtful(std::size_t numbers) const;
  [[nodiscard]] bool needs_multax() const;
  [[nodiscard]] bool may_go_on_round(const Position& position) const;
  void break_motion();
  void remember_link();
  void attach_link(Move& move);

  // interpret_cycle.cpp
  void take_cycle();
  void begin_cycle();
  void take_changed_cycle();
  void end_cycle();
  void doubt_cycle();
  void doubt_moves_before_stray_end();
  void count_holes();
  [[nodiscard]] bool is_cycle_doubtful() const { return cycle_.is_on && cycle_.is_contradicted; }
  void emit_doubtful(const Position& position);
  void emit_cycle(const Position& position, const DrillCycle& cycle);
  void emit_cycle_step(const Position& position, const Vec3& tip_local, bool is_rapid);
  void emit_cycle_retract(const Position& position, const Vec3& tip_local);

  // interpret_curve.cpp
  void take_arc();
  void take_unread_curve();
  void take_indirv();
  void take_tlon();
  void begin_curve();
  void take_knots();
  void take_control_point();
  void flush_curve();
  void attach_curve(const Position& position, Move& move);
  void attach_arc(const Position& position, Move& move);
  void attach_spline(Move& move);
  void fit(const ArcStatement& arc, const Vec3& start, Move& move);
  void doubt_autodesk_sense(ArcStatement& arc, const Move& move);
  void vote(const ArcStatement& arc, const Vec3& tip, const Vec3& direction);
  void note_direction(const Move& move);
  void close_arcs();
  void close_autodesk_arcs();
  void close_arcs_as(ArcSense sense);
  [[nodiscard]] bool is_round_in_nccs(const Position& position, const ArcStatement& arc, Move& move) const;
  [[nodiscard]] bool is_reached_the_short_way(const Position& position) const;
  [[nodiscard]] static ArcSense shorter_way(ArcStatement arc, const Vec3& start, const Vec3& end);

  // interpret_notes.cpp
  void write_notes();
  void note_motion();
  void note_arcs();

  // interpret_tool.cpp
  void take_cutter();
  void take_creo_cutter(std::string_view text);
  void take_tldata();
  void take_tool_number();
  void take_load();
  void take_flute_length();
  void take_tool_name(std::string_view text);
  void set_cutter(const CutterStatement& cutter, double flute_length_mm);
  void change_number(int number);
  void resolve_tool();
  [[nodiscard]] std::size_t find_or_add_tool();
  void note_no_cutter(const std::string& note);
  void name_operation(std::string name);
  void resolve_operation();

  // interpret_frame.cpp
  void take_comment();
  [[nodiscard]] bool is_matrix_row(std::string_view text);
  void take_catia_row(std::string_view text);
  void fail_catia_rows();
  void take_creo_comment();
  void note_creo_csys();
  void take_msys();
  void take_csys();
  void take_mcs();
  void take_mcsys();
  void take_rotabl();
  void take_trntyp();
  void take_trans();
  void take_mode();
  void set_frame(const RigidTransform& to_part);
  [[nodiscard]] std::optional<RigidTransform> make_frame(const Vec3& origin, const Vec3& x, const Vec3& y,
                                                         const char* what);
  void take_tlaxis();

  // interpret_setup.cpp
  [[nodiscard]] static std::optional<TableTurn> clt_turn(std::span<const Argument> arguments);
  [[nodiscard]] Eigen::Matrix3d clt_setup() const;
  void settle_setup();
  void note_setup_statement();
  void take_clt_turn(const TableTurn& turn);
  void take_clt_axis();
  void end_clt_feature();
  void take_camera();
  void take_ppword();
  [[nodiscard]] bool names_axes_only() const;

  void take_units();
  void take_tool_path();
  void close_block();
  void doubt_blocks_without_msys();
  [[nodiscard]] const char* frame_reason() const;

  Toolpath& path_;
  Dialect dialect_;
  MotionRecords* records_;
  const Statement* statement_ = nullptr;  // the one being taken
  std::vector<Argument> arguments_;       // of it
  Diagnostics errors_;
  std::size_t errors_not_listed_ = 0;
  bool is_hopeless_ = false;
  std::string first_assignment_;  // of a number to a symbol
  std::size_t first_assignment_line_ = 0;

  // motion
  bool can_link_ = false;    // the motion broke off at the end of the last move
  bool was_loaded_ = false;  // a tool was loaded since the last move
  std::optional<Pose> last_pose_;        // part coordinates; nothing: the next position is alone
  const char* unknown_start_ = nullptr;  // why the next motion's start is not known
  const char* last_frame_reason_ = nullptr;
  CutcomSide cutcom_ = CutcomSide::none;
  bool is_cutter_centre_said_ = false;  // by the user: positions under CUTCOM are the cutter's centre
  bool is_cutter_centre_ = false;       // so says the user, or the file for this sequence
  bool was_compensated_ = false;   // the last position was
  bool was_ever_compensated_ = false;
  const char* doubt_ = nullptr;    // why the position being taken cannot be checked
  bool is_rapid_ = false;
  bool is_broken_ = false;               // nothing is swept from the last position to the next
  std::optional<ArcStatement> arc_;      // to the next position, in the block's frame
  std::optional<ArcStatement> last_arc_;  // on which the positions of the last statement went on
  std::size_t arc_statement_ = kNone;    // CIRCLE, MOVARC or INDIRV
  std::optional<Vec3> start_tangent_;    // INDIRV
  bool has_indirv_ = false;              // that no motion has used
  std::optional<Vec3> last_direction_;   // of the last move where it was straight, part coordinates
  struct OpenArc {
    std::size_t move = 0;
    ArcStatement arc;  // part coordinates
    std::string_view not_checked_reason;  // whatever its sense
  };
  std::size_t run_begin_ = 0;  // the first move since the last tool or operation
  // The same since the last OFF of each, or the last zeros.
  std::size_t cutcom_run_ = 0, adjust_run_ = 0, spline_run_ = 0, trans_run_ = 0, origin_run_ = 0;
  std::vector<OpenArc> open_arcs_;  // whose sense the rest of the file must tell
  std::optional<Pose> last_hole_;    // where the last position was a hole: what GODLTA goes on from, not where the tool is
  CycleState cycle_;
  std::vector<Argument> cycle_words_;  // of the last cycle that was described
  const char* cycle_reason_ = Reasons::kCycle;  // why its drill is not understood
  std::size_t rapid_statement_ = kNone;
  std::optional<bool> multax_;
  Vec3 modal_axis_ = Vec3::UnitZ();  // the last axis given, or TLAXIS
  Vec3 fixed_axis_ = Vec3::UnitZ();  // TLAXIS
  bool is_tlaxis_new_ = false;       // since the last position
  Feed feed_;                        // of FEDRAT
  bool has_feed_per_turn_ = false;   // a FEDRAT stated one: what one without a unit means is then not known
  std::size_t curve_statement_ = kNone;  // NURBS whose control points are being read
  std::size_t curve_line_ = 0;
  std::optional<Position> curve_end_;
  std::vector<double> knots_;
  std::vector<Vec3> control_local_;
  bool is_curve_understood_ = false;
  bool was_from_ = false;  // the last move was FROM

  // tools and operations
  ToolState tool_;
  struct ToolKey {  // what makes two tools of the file the same
    std::optional<int> number;
    std::optional<std::array<double, 7>> cutter;
    double diameter_mm = 0;
    std::string name;
    auto operator<=>(const ToolKey&) const = default;
  };
  std::map<ToolKey, std::size_t> tool_of_key_;
  std::map<int, std::size_t> tool_of_number_;  // the last one seen under a number
  std::size_t tool_index_ = kNone;
  bool is_tool_changed_ = false;
  std::string operation_name_;
  std::size_t operation_line_ = 0;
  bool is_operation_new_ = false;
  std::size_t operation_index_ = kNone;
  Word previous_word_ = Word::comment;
  std::size_t previous_statement_ = kNone;  // that word's
  std::string last_insert_;

  // frames
  double mm_per_unit_;
  bool is_unit_stated_ = false;  // by a statement read until now
  RigidTransform to_part_;
  bool is_frame_recorded_ = false;  // the last of records_->frames is the one in force
  std::size_t block_ = 0;
  bool is_block_open_ = false;
  bool is_between_blocks_ = false;  // of NX
  bool is_msys_outside_ = false;    // an MSYS stood there
  const char* block_reason_ = nullptr;
  const char* matrix_reason_ = nullptr;
  bool block_has_msys_ = false, is_msys_ever_ = false;
  std::size_t block_begin_ = 0;  // its first move
  std::vector<std::pair<std::size_t, std::size_t>> blocks_without_msys_;  // their moves
  const char* csys_reason_ = nullptr;
  const char* mcs_reason_ = nullptr;
  const char* trans_reason_ = nullptr;
  const char* origin_reason_ = nullptr;
  const char* unread_frame_reason_ = nullptr;
  const char* contour_reason_ = nullptr;
  const char* adjust_reason_ = nullptr;
  const char* spline_reason_ = nullptr;
  const char* turning_reason_ = nullptr;
  const char* trntyp_reason_ = nullptr;
  const char* mode_reason_ = nullptr;
  const char* multax_reason_ = nullptr;
  const char* cutter_reason_ = nullptr;   // no cutter since a statement that may have been one
  const char* loading_reason_ = nullptr;  // no tool change since a statement that may have been one
  const char* setup_reason_ = nullptr;
  const char* machine_shift_reason_ = nullptr;
  const char* machine_cycle_reason_ = nullptr;
  const char* machine_steps_reason_ = nullptr;
  std::vector<TableTurn> turns_;                // of CLT, those in force
  std::optional<Vec3> clt_axis_ = Vec3::UnitZ();  // TLAXIS, in model axes; nothing: not understood
  std::optional<Eigen::Matrix3d> first_setup_;             // of the first position
  std::size_t turned_setup_line_ = 0;           // where that is not the model's
  const char* clt_setup_reason_ = nullptr;
  bool is_setup_new_ = false;                   // since the last position
  std::string_view setup_word_;
  std::size_t setup_line_ = 0;
  int catia_row_ = -1;              // lines seen since $$*CATIA0; -1: none
  bool is_catia_nameless_ = false;  // the first line after it looks like a row
  std::array<double, 12> catia_rows_{};
  bool is_tlaxis_ignored_ = false;

  NamedReasons reasons_;

  // told once at the end
  std::size_t renormalised_ = 0;
  double worst_axis_length_ = 1;
  Tally csys_told_;
  std::size_t cutters_without_tool_ = 0;
  Tally cutters_recomputed_;
  Tally cutcoms_;
  Tally offsets_chosen_;
  Tally not_swept_;
  std::size_t right_votes_ = 0, left_votes_ = 0;         // lines that touch arcs, by the sense they tell
  std::size_t turned_vectors_ = 0, wrong_way_arcs_ = 0;  // of Autodesk: clockwise arcs right-handed, and left-handed
  std::size_t smooth_arcs_ = 0, reversing_arcs_ = 0;     // the same, by whether it is the sense they are read in
  Tally radius_errors_;
  double worst_radius_error_mm_ = 0;
  Tally cycles_never_begun_;
  Tally cycles_never_ended_;
  Tally cycles_without_retract_;
  Tally plain_after_tilt_;
  bool is_last_tilted_ = false;
  bool has_end_ = false;
};

/// The records of `path`'s moves, by reading its bytes once more.
[[nodiscard]] MotionRecords read_motion_records(const Toolpath& path);

}  // namespace gouge
