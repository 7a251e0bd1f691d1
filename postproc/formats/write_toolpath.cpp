#include "postproc/formats/write_toolpath.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/path/chords.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/formats/toolpath_format.h"
#include "postproc/formats/verify_written.h"

namespace gouge {
namespace {

bool is_after_retract(const Move& move) { return kind_of(move.not_checked_reason) == ReasonKind::after_retract; }

// Returns whether a motion ends where the file states, although it may not be checked. Then only its start or the
// cutter's side of the contour is uncertain.
bool is_understood(const Move& move) { return is_motion_known(move.not_checked_reason) || is_after_retract(move); }

// Returns whether the file or the user states that all compensated positions are those of the cutter's centre.
bool are_on_centre(const Toolpath& path, const MotionRecords& records) {
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const bool is_compensated = records.of_move[i].cutcom != CutcomSide::none;
    if (is_compensated && !path.moves[i].not_checked_reason.empty()) return false;
  }
  return true;
}

bool is_tilted(const Move& move) {
  return (move.end.axis - Vec3::UnitZ()).cwiseAbs().maxCoeff() > Tolerance::kExactDirection;
}

// Returns whether the dialect cannot state the whole shape of a cutter.
bool loses_shape(CutterForm form, const PathTool& tool) {
  if (!tool.cutter) return tool.stated_diameter_mm > 0 && form != CutterForm::diameter_alone;
  switch (form) {
    case CutterForm::whole:
      return false;
    case CutterForm::with_diameter:
      return !(tool.cutter->d_mm > 0);
    case CutterForm::without_angles:
      return std::abs(tool.cutter->alpha_deg) > 0;
    case CutterForm::diameter_alone:
    case CutterForm::none:
      break;
  }
  return true;
}

// Returns the first motion of a program that positions and axes do not state: more than half a turn of a rotary joint, or
// a turn without tool centre point control.
std::optional<Diagnostic> find_lost_joints(const Toolpath& path) {
  constexpr double kHalfTurn_rad = std::numbers::pi - 1e-6;
  if (path.joints == nullptr || path.dialect != gcode_dialect().id) return std::nullopt;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto &from = path.joints->start[i], &to = path.joints->end[i];
    if (!from || !to) continue;
    const double turn = std::max(std::abs((*to)[0] - (*from)[0]), std::abs((*to)[1] - (*from)[1]));
    const Move& move = path.moves[i];
    if (turn > kHalfTurn_rad)
      return make_error("convert-joints",
                        "a rotary joint turns by " + display_text(turn * 180 / std::numbers::pi, 3) +
                            " degrees, and CL data do not state its way; expected at most half a turn in a move",
                        path.file, move.line);
    if (move.runs_joints && turn > Tolerance::kSameDirection)
      return make_error("convert-joints",
                        "rotary joints turn without tool centre point control, and CL data do not state such a motion",
                        path.file, move.line);
  }
  return std::nullopt;
}

class PathWriter {
 public:
  PathWriter(const Toolpath& path, const Dialect& target)
      : path_(path),
        target_(target),
        records_(format_of(path).records(path)),
        is_on_centre_(are_on_centre(path, *records_)) {}

  Result<WrittenToolpath> run();

 private:
  [[nodiscard]] std::optional<Diagnostic> find_obstacle() const;
  [[nodiscard]] std::unique_ptr<MotionSink> make_sink() const;
  void write_move(std::size_t index);
  void write_motion(std::size_t index);
  void write_cutcom(std::size_t index);
  void write_spindle(const Move& move);
  void write_rapid();
  void write_feed(const Move& move);
  void forget_feed();
  void refuse_feed(const Move& move, const std::string& what);
  void expect(const Pose& end, bool is_alone, double sweep_rad = 0);
  [[nodiscard]] bool write_arc(std::size_t index);
  void note(const char* code, std::size_t count, const std::string& noun, const std::string& what);
  void note_losses();

  const Toolpath& path_;
  Dialect target_;
  std::shared_ptr<const MotionRecords> records_;
  bool is_on_centre_;
  std::unique_ptr<MotionSink> sink_;
  WrittenToolpath written_;
  std::size_t tool_ = kNone, operation_ = kNone;
  Feed feed_;                 // feed in force in the written file
  bool is_feed_due_ = false;  // the feed must be stated again before the next feed motion
  std::optional<Diagnostic> feed_error_;
  CutcomSide cutcom_ = CutcomSide::none;
  bool is_spindle_stopped_ = false;
  bool is_checked_ = true;  // whether the move being written is checked
  std::size_t breaks_ = 0, lost_breaks_ = 0, lost_rapids_ = 0, lost_cutcoms_ = 0, lost_feeds_ = 0, unstated_feeds_ = 0;
  std::size_t lost_arcs_ = 0, splines_ = 0, cycles_ = 0;
  std::vector<ExpectedMotion> expected_;
  std::size_t index_ = 0;  // index of the move being written
};

std::optional<Diagnostic> PathWriter::find_obstacle() const {
  if (!target_.is_written) {
    return make_error("convert-dialect",
                      "mastercam-nci is read only: how its tools and planes are written is not known; expected another "
                      "dialect for --to",
                      path_.file);
  }
  std::size_t count = 0;
  const Move* first = nullptr;
  for (const Move& move : path_.moves) {
    if (is_understood(move)) continue;
    if (count++ == 0) first = &move;
  }
  if (first != nullptr) {
    return make_error("convert-not-understood",
                      std::to_string(count) + " of " + std::to_string(path_.moves.size()) +
                          " moves are not understood (" + std::string(first->not_checked_reason) +
                          "), so they cannot be written in another way; without --to the file is copied as it is",
                      path_.file, first->line);
  }
  const auto tapping =
      std::ranges::find_if(records_->of_move, [](const MotionRecord& record) { return record.is_tapping; });
  if (!target_.has_positions_alone && tapping != records_->of_move.end()) {
    const auto index = static_cast<std::size_t>(tapping - records_->of_move.begin());
    return make_error("convert-cycle",
                      "a tapping cycle cannot be written as plain moves, in which the spindle would not turn back; "
                      "without --to the file is copied as it is",
                      path_.file, path_.moves[index].line);
  }
  if (target_.has_positions_alone && !is_on_centre_) {
    return make_error("convert-dialect",
                      "goto-list cannot say that positions are compensated by CUTCOM; expected another dialect for "
                      "--to, or --cutcom centre where they are the cutter centre",
                      path_.file);
  }
  const auto retracted = std::ranges::find_if(path_.moves, is_after_retract);
  if (target_.has_positions_alone && retracted != path_.moves.end()) {
    return make_error("convert-dialect",
                      "goto-list cannot say that the tool retracts before this move; expected another dialect for --to",
                      path_.file, retracted->line);
  }
  if (!target_.has_z_alone) return std::nullopt;
  const auto tilted = std::ranges::find_if(path_.moves, is_tilted);
  if (tilted == path_.moves.end()) return std::nullopt;
  return make_error("convert-dialect",
                    "camworks-clt has no tool axis, and this move's is not +Z; expected another dialect for --to",
                    path_.file, tilted->line);
}

std::unique_ptr<MotionSink> PathWriter::make_sink() const {
  std::string_view name = path_.file;
  name.remove_prefix(std::min(name.find_last_of('/') + 1, name.size()));
  SinkOptions options;
  options.dialect = target_;
  options.unit = path_.unit;
  options.name = name.substr(0, name.find('.'));
  options.is_on_centre = is_on_centre_;
  options.is_tilted = std::ranges::any_of(path_.moves, is_tilted);
  const Decimals decimals = format_of(path_).decimals(path_, *records_);
  options.decimals = decimals.coordinates;
  options.axis_decimals = decimals.axes;
  return format_called(target_.format).make_sink(options);
}

void PathWriter::expect(const Pose& end, bool is_alone, double sweep_rad) {
  ExpectedMotion expected;
  expected.end = end;
  expected.move = index_;
  expected.is_alone = is_alone;
  expected.is_checked = is_checked_;
  expected.feed = path_.moves[index_].feed();
  expected.sweep_rad = sweep_rad;
  if (sweep_rad < 0 || sweep_rad > 0) expected.axis = path_.arcs[path_.moves[index_].curve].axis;
  expected_.push_back(expected);
}

// Writes an arc. Half a turn, and a whole turn of a helix, can be read with either sense. Some writers of the dialect
// that states sweeps mean the opposite sense, so such arcs are written in parts in this dialect.
bool PathWriter::write_arc(std::size_t index) {
  constexpr double kHalfTurn = std::numbers::pi, kNear_rad = 0.2;
  const Move& move = path_.moves[index];
  PathArc arc = path_.arcs[move.curve];
  Pose start = path_.start_of(index);
  const double sweep = std::abs(arc.sweep_rad);
  const bool is_flat_circle = (start.tip - move.end.tip).norm() <= 0 &&
                              (start.axis - move.end.axis).cwiseAbs().maxCoeff() <= Tolerance::kExactDirection;
  const bool is_open =
      std::abs(sweep - kHalfTurn) <= kNear_rad || (std::abs(sweep - 2 * kHalfTurn) <= kNear_rad && !is_flat_circle);
  if (target_.arc_rule != ArcRule::by_vector_or_against || !is_open) {
    if (!sink_->go_round(arc, start, move.end)) return false;
    expect(move.end, false, arc.sweep_rad);
    return true;
  }
  const Vec3 from = start.tip - arc.center;
  const double radius = (from - from.dot(arc.axis) * arc.axis).norm();
  const std::vector<Pose> ends = chords_of(path_, index, radius / 2);
  arc.sweep_rad /= static_cast<double>(ends.size());
  for (const Pose& end : ends) {
    if (&end != &ends.front()) write_rapid();
    if (!sink_->go_round(arc, start, end)) return false;
    expect(end, false, arc.sweep_rad);
    start = end;
  }
  return true;
}

void PathWriter::write_cutcom(std::size_t index) {
  const CutcomSide side = records_->of_move[index].cutcom;
  if (side != cutcom_ && !sink_->set_cutcom(side)) ++lost_cutcoms_;
  cutcom_ = side;
}

void PathWriter::write_spindle(const Move& move) {
  if (move.is_spindle_stopped() != is_spindle_stopped_ && !target_.has_positions_alone)
    sink_->stop_spindle(move.is_spindle_stopped());
  is_spindle_stopped_ = move.is_spindle_stopped();
}

// Writes a RAPID, which holds for only one motion.
void PathWriter::write_rapid() {
  if (path_.moves[index_].feed_unit == FeedUnit::rapid && !sink_->make_rapid()) ++lost_rapids_;
}

// A new block of NX has no feed. In other dialects the old feed stays in force, and is stated again.
void PathWriter::forget_feed() {
  is_feed_due_ = true;
  if (target_.has_blocks) feed_ = {};
}

void PathWriter::refuse_feed(const Move& move, const std::string& what) {
  if (feed_error_) return;
  feed_error_ = make_error("convert-feed", what, path_.file, move.line);
}

// Writes a FEDRAT. It is modal: a motion without one would run at the previous feed.
void PathWriter::write_feed(const Move& move) {
  const Feed feed = move.feed();
  const bool is_same = feed.unit == feed_.unit && !(std::abs(feed.mm - feed_.mm) > 0);
  if (feed.is_number()) {
    if (is_same && !is_feed_due_) return;
    if (!sink_->set_feed(feed)) return void(++lost_feeds_);
    feed_ = feed;
    is_feed_due_ = false;
    return;
  }
  if (target_.has_positions_alone) {
    if (feed.unit == FeedUnit::not_understood) ++lost_feeds_;
    return;
  }
  if (feed.unit == FeedUnit::not_understood) {
    return refuse_feed(move,
                       "the feed of this move is stated in words that are not understood (inverse time, two units, no "
                       "unit after a feed per revolution), so it cannot be written in another way; expected FEDRAT or "
                       "CYCLE with one number and MMPM, MMPR, IPM or IPR");
  }
  if (feed_.is_number()) {
    return refuse_feed(
        move,
        "the file states no feed for this move, and " + std::string(target_.id) +
            " would run it at that of the move before; expected a FEDRAT before it, or a cycle that states its feed");
  }
  ++unstated_feeds_;
}

void PathWriter::write_motion(std::size_t index) {
  const Move& move = path_.moves[index];
  if (move.curve_kind == CurveKind::none) {
    sink_->go_to(move.end);
    return expect(move.end, !move.has_start);
  }
  if (move.curve_kind == CurveKind::arc && write_arc(index)) return;
  ++(move.curve_kind == CurveKind::arc ? lost_arcs_ : splines_);
  const std::vector<Pose> chords = chords_of(path_, index, kChordError_mm);
  for (const Pose& pose : chords) {
    if (&pose != &chords.front()) write_rapid();
    sink_->go_to(pose);
    expect(pose, false);
  }
}

void PathWriter::write_move(std::size_t index) {
  const Move& move = path_.moves[index];
  index_ = index;
  is_checked_ = move.not_checked_reason.empty();
  const bool has_retract = is_after_retract(move);
  const bool is_tool_new = move.tool != tool_ && move.tool != kNone;
  const bool says_tools = !target_.has_positions_alone;
  if (!move.has_start && index > 0 && !(is_tool_new && says_tools) && !has_retract) {
    sink_->break_motion() ? ++breaks_ : ++lost_breaks_;
    forget_feed();
  }
  if (is_tool_new) {
    tool_ = move.tool;
    sink_->change_tool(path_.tools[tool_]);
    forget_feed();
  }
  if (move.operation != operation_ && move.operation != kNone) {
    operation_ = move.operation;
    const std::string& name = path_.operations[operation_].name;
    if (!name.empty()) sink_->begin_operation(name);
  }
  if (has_retract) sink_->retract();
  write_cutcom(index);
  write_spindle(move);
  move.feed_unit == FeedUnit::rapid ? write_rapid() : write_feed(move);
  if (move.kind == MoveKind::cycle) ++cycles_;
  write_motion(index);
}

// Adds a note with a count: "3 arcs written ...", "1 arc written ...". `what` must fit both forms.
void PathWriter::note(const char* code, std::size_t count, const std::string& noun, const std::string& what) {
  if (count == 0) return;
  written_.notes.push_back(make_warning(code, count_text(count, noun) + " " + what, path_.file));
}

void PathWriter::note_losses() {
  const std::string straight = "written as straight moves within " + exact_text(kChordError_mm) + " mm: ";
  note("convert-chords", lost_arcs_, "arc", straight + "arcs like these are not written in this dialect");
  note("convert-chords", splines_, "spline", straight + "splines are read, and written in no dialect");
  note("convert-cycles", cycles_, "move",
       "of drilling cycles written as plain moves, without the pecks and dwells of their cycles");
  note("convert-breaks", breaks_, "position", "that nothing known leads to: a GOHOME or a new block stands before");
  note("convert-breaks", lost_breaks_, "position",
       "that nothing known leads to: the dialect cannot say so and will read straight moves there");
  note("convert-rapid", lost_rapids_, "rapid move", "written as feed: the dialect has no rapid moves");
  note("convert-feed", lost_feeds_, "feed move", "whose feed is left out: the dialect has no feeds");
  note("convert-feed", unstated_feeds_, "feed move", "without a feed, as in the input: it states none before them");
  note("convert-cutcom", lost_cutcoms_, "CUTCOM statement", "left out: the dialect cannot say it");
  const auto count_tools = [&](auto is_lost) {
    return static_cast<std::size_t>(std::ranges::count_if(path_.tools, is_lost));
  };
  note("convert-tools", count_tools([&](const PathTool& tool) { return loses_shape(target_.cutter_form, tool); }),
       "tool", "without the whole shape, which the dialect cannot say; give it in a tool library");
  const auto has_length = [](const PathTool& tool) { return tool.stickout_mm > 0 || tool.loaded_length_mm > 0; };
  note("convert-tools", count_tools(has_length), "tool",
       "without its stick-out or LENGTH, which are not written: compare them with the tool library");
}

Result<WrittenToolpath> PathWriter::run() {
  if (auto obstacle = find_obstacle()) return std::move(*obstacle);
  sink_ = make_sink();
  for (std::size_t i = 0; i < path_.moves.size() && !feed_error_; ++i) write_move(i);
  if (feed_error_) return std::move(*feed_error_);
  written_.bytes = sink_->finish();
  note_losses();
  if (auto error = verify_written(path_, target_, expected_, lost_breaks_, written_)) return std::move(*error);
  return std::move(written_);
}

}  // namespace

Result<WrittenToolpath> write_toolpath(const Toolpath& path, const Dialect& target) {
  if (auto error = find_lost_joints(path)) return std::move(*error);
  return PathWriter(path, target).run();
}

}  // namespace gouge
