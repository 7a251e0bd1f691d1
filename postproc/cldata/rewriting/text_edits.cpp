#include "lib/path/run_kind.h"
#include "postproc/cldata/rewriting/rewriters.h"

#include <algorithm>
#include <utility>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/lexing/statement_at.h"
#include "postproc/cldata/rewriting/arc_text.h"
#include "postproc/cldata/rewriting/change_table.h"
#include "postproc/cldata/rewriting/goto_text.h"

namespace gouge {
namespace {

/// The axis of a position of three numbers after an axis that was written: the implied one, the one written last, or
/// none that the file states.
enum class PlainAxis { implied, last, uncertain };

class CorrectedWriter {
 public:
  CorrectedWriter(const Toolpath& path, const MotionRecords& records, const std::vector<PathChange>& changes)
      : path_(path),
        read_(records),
        records_(read_.of_move),
        goto_text_(path, read_),
        arc_text_(path, read_),
        dialect_(dialect_or_apt(path.dialect)),
        has_no_axes_(!dialect_.is_axis_modal &&
                     std::ranges::none_of(records_, [](const MotionRecord& r) { return r.numbers == 6; })),
        changes_(path.moves.size(), changes),
        replaced_(path) {
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      if (changes_.is_straightened(i)) drop_curve(i);
    }
  }

  Result<Edits> edits();

 private:
  [[nodiscard]] std::optional<Diagnostic> find_unwritable() const;
  void drop_curve(std::size_t move);
  [[nodiscard]] std::optional<Diagnostic> redescribe_arc(std::size_t move);
  [[nodiscard]] std::optional<Diagnostic> describe_inserted_arcs(std::size_t move);
  [[nodiscard]] Pose new_start(std::size_t move) const;
  [[nodiscard]] WrittenArc in_statement(std::size_t move, const PathArc& arc, const Pose& start, const Pose& end) const;
  [[nodiscard]] std::optional<Diagnostic> find_stuck(std::size_t first, std::size_t last) const;
  [[nodiscard]] std::string rewritten(std::size_t first, std::size_t last);
  [[nodiscard]] std::string shifted_holes(std::size_t first, std::size_t last) const;
  [[nodiscard]] bool has_curve_left(std::size_t first, std::size_t last) const;
  [[nodiscard]] Pose local_end(std::size_t move) const;
  void begin_statement(const MotionRecord& record, bool is_new_block);
  [[nodiscard]] bool needs_rewriting(std::size_t first, std::size_t last) const;
  [[nodiscard]] WrittenPosition written(const MotionRecord& record, const Pose& local, bool is_axis_kept);
  // Returns whether the axis is written. A curve has no numbers of its own as a model, so it follows the previous
  // position.
  [[nodiscard]] bool is_axis_kept(const MotionRecord& record) const {
    return record.numbers == 6 || (record.form == PositionForm::curve && is_axis_usual_ && !dialect_.is_axis_modal);
  }
  [[nodiscard]] PlainAxis plain_axis(const MotionRecord& record) const;
  // Returns whether a position without an axis is, or may be, read with the last written axis.
  [[nodiscard]] bool keeps_axis(const MotionRecord& record) const { return plain_axis(record) != PlainAxis::implied; }
  [[nodiscard]] std::string rapid_line(const MotionRecord& record) const;
  [[nodiscard]] std::string insertions(std::size_t move);
  [[nodiscard]] std::string in_place(std::size_t first, std::size_t last);
  [[nodiscard]] std::string one_by_one(std::size_t first, std::size_t last);
  [[nodiscard]] std::string framed(const MotionRecord& record, const WrittenPosition& position, std::string text) const;

  const Toolpath& path_;
  const MotionRecords& read_;
  const std::vector<MotionRecord>& records_;  // the records in read_
  GotoText goto_text_;
  ArcText arc_text_;
  Dialect dialect_;
  bool has_no_axes_;  // no position of the file has an axis, and none keeps that of another
  ChangeTable changes_;
  ReplacedStatements replaced_;
  // description of the arcs of the move being written; nothing: they are straight
  std::vector<std::string> inserted_arcs_;
  bool is_axis_usual_ = false;         // the last position was written with its axis
  Vec3 axis_read_ = Vec3::UnitZ();     // the modal axis after the last position of the file that was read
  Vec3 axis_written_ = Vec3::UnitZ();  // the modal axis after the last position that was written
};

// Returns the end of `move` in the frame of its statement, in mm.
Pose CorrectedWriter::local_end(std::size_t move) const {
  const Pose& end =
      changes_[move] != nullptr && changes_[move]->new_end ? *changes_[move]->new_end : path_.moves[move].end;
  return records_[move].frame->to_part.inverse().pose(end);
}

// Drops the description of a curve: CIRCLE, MOVARC or INDIRV before the position, KNOT and CNTRL after a NURBS.
void CorrectedWriter::drop_curve(std::size_t move) {
  const MotionRecord& record = records_[move];
  if (record.curve_statement != kNone) replaced_[record.curve_statement].clear();
  if (record.form != PositionForm::curve) return;
  for (std::size_t s = record.statement + 1; s < path_.statements.size(); ++s) {
    const Word word = statement_at(path_, s).word;
    if (word == Word::knot || word == Word::cntrl) replaced_[s].clear();
    if (word != Word::knot && word != Word::cntrl && word != Word::comment) return;
  }
}

Pose CorrectedWriter::new_start(std::size_t move) const {
  return (changes_[move - 1] != nullptr ? changes_[move - 1]->new_end : std::nullopt).value_or(path_.start_of(move));
}

// Returns the arc in the frame of its statement. Its vector keeps its sense.
WrittenArc CorrectedWriter::in_statement(std::size_t move, const PathArc& arc, const Pose& start,
                                         const Pose& end) const {
  const RigidTransform to_local = records_[move].frame->to_part.inverse();
  const double sense = (arc.sweep_rad < 0) == (path_.arcs[path_.moves[move].curve].sweep_rad < 0) ? 1 : -1;
  return {{to_local.point(arc.center), to_local.direction(sense * arc.axis), sense * arc.sweep_rad},
          to_local.point(start.tip),
          to_local.point(end.tip)};
}

std::optional<Diagnostic> CorrectedWriter::describe_inserted_arcs(std::size_t move) {
  const PathChange& change = *changes_[move];
  Pose start = new_start(move);
  inserted_arcs_.assign(change.inserted_before.size(), "");
  for (std::size_t k = 0; k < change.inserted_arcs.size(); ++k) {
    const Pose& end = change.inserted_before[k];
    if (const std::optional<PathArc>& arc = change.inserted_arcs[k]) {
      const Result<std::string> text = arc_text_.description(move, in_statement(move, *arc, start, end));
      if (!text) return text.error();
      inserted_arcs_[k] = goto_text_.with_line_end(*text);
    }
    start = end;
  }
  return std::nullopt;
}

// Describes an arc with other numbers, after the positions that lead to its start.
std::optional<Diagnostic> CorrectedWriter::redescribe_arc(std::size_t move) {
  const MotionRecord& record = records_[move];
  const PathChange& change = *changes_[move];
  const RigidTransform to_local = record.frame->to_part.inverse();
  const Pose start = change.inserted_before.empty() ? new_start(move) : change.inserted_before.back();
  const WrittenArc arc = in_statement(move, *change.new_arc, start, change.new_end.value_or(path_.moves[move].end));
  if (record.form == PositionForm::curve &&
      !goto_text_.is_same_axis(to_local.direction(start.axis), local_end(move).axis))
    return make_error("write-arc", "a TLON keeps the tool axis of its start", path_.file, path_.moves[move].line);
  const Result<std::string> text = arc_text_.description(move, arc);
  if (!text) return text.error();
  replaced_[record.curve_statement] = *text;
  if (changes_.has_insertion(move)) {
    const std::size_t first = arc_text_.first_statement(move);
    if (first != record.curve_statement) replaced_[first] = std::string(replaced_.bytes_of(first));
    replaced_[first].insert(0, insertions(move));
  }
  if (record.form != PositionForm::curve) return std::nullopt;
  const Result<std::string> tlon = arc_text_.tlon(move, arc);
  if (!tlon) return tlon.error();
  replaced_[record.statement] = *tlon;
  return std::nullopt;
}

// Returns whether positions stay on the arc that describes a statement. Some straight and some round positions of one
// statement cannot be written.
bool CorrectedWriter::has_curve_left(std::size_t first, std::size_t last) const {
  bool has_straightened = false, has_round = false;
  for (std::size_t i = first; i < last; ++i) {
    const Move& move = path_.moves[i];
    const bool is_straight = move.curve_kind == CurveKind::none && is_motion_known(move.not_checked_reason);
    if (move.kind != MoveKind::arc || is_straight) continue;  // a list may begin at the position of the tool
    (changes_.is_straightened(i) ? has_straightened : has_round) = true;
  }
  const bool has_new_start = changes_.has_new_end(last - 1) && last < path_.moves.size() &&
                             path_.moves[last].kind == MoveKind::arc && path_.moves[last].has_start &&
                             !changes_.is_straightened(last) && !changes_.has_new_arc(last);
  return (has_straightened && has_round) || has_new_start;
}

bool CorrectedWriter::needs_rewriting(std::size_t first, std::size_t last) const {
  for (std::size_t i = first; i < last; ++i) {
    if (changes_.is_changed(i)) return true;
  }
  const MotionRecord& record = records_[first];
  const bool is_step =
      record.form == PositionForm::godlta || (record.form == PositionForm::cycle && record.numbers == 0);
  if (is_step) return first > 0 && changes_.has_new_end(first - 1);
  if (record.form == PositionForm::unread) return false;
  if (path_.moves[first].not_checked_reason == Reasons::kPlainAxis) return false;  // uncertain in the file too
  const bool relies_on_axis = keeps_axis(record) && (record.numbers == 3 || record.form == PositionForm::curve);
  return relies_on_axis && !goto_text_.is_same_axis(record.implied_axis_local, axis_written_);
}

// Returns the axis that the reader gives to a position of three numbers here. A position with an axis that was written
// into a file without axes, or under MULTAX/OFF, leaves MULTAX/OFF behind it.
PlainAxis CorrectedWriter::plain_axis(const MotionRecord& record) const {
  const bool is_off = record.is_multax_off || has_no_axes_;
  if (dialect_.is_axis_modal) return PlainAxis::last;
  if (dialect_.has_known_plain_axis && (is_off || !dialect_.has_axes_under_multax)) return PlainAxis::implied;
  return dialect_.locks_axis && is_off ? PlainAxis::last : PlainAxis::uncertain;
}

// Returns the position to write for `local`, and sets the axis that it leaves in force. The axis is omitted if 3
// numbers have the same meaning.
WrittenPosition CorrectedWriter::written(const MotionRecord& record, const Pose& local, bool is_axis_kept) {
  WrittenPosition position;
  position.tip = local.tip / record.frame->mm_per_unit;
  const PlainAxis plain = plain_axis(record);
  const bool is_last = plain == PlainAxis::implied || goto_text_.is_same_axis(local.axis, axis_written_);
  const bool is_implied = plain == PlainAxis::last || goto_text_.is_same_axis(local.axis, record.implied_axis_local);
  if (is_axis_kept || !is_last || !is_implied) position.axis = local.axis;
  axis_written_ = local.axis;
  return position;
}

// Returns the text within the MULTAX statements that it needs. Under MULTAX/OFF six numbers are two positions, so a
// position with an axis switches MULTAX on for itself. It does so in a file without axes too. Otherwise a position of
// three numbers after it would be ambiguous.
std::string CorrectedWriter::framed(const MotionRecord& record, const WrittenPosition& position,
                                    std::string text) const {
  if (!(record.is_multax_off || has_no_axes_) || !position.axis || record.numbers == 6) return text;
  return goto_text_.with_line_end("MULTAX/ON") + goto_text_.with_line_end(std::move(text)) +
         goto_text_.with_line_end("MULTAX/OFF");
}

std::string CorrectedWriter::rapid_line(const MotionRecord& record) const {
  const bool is_template = record.rapid_statement != kNone && replaced_.begins_with(record.rapid_statement, "RAPID");
  return goto_text_.with_line_end(is_template ? std::string(replaced_.bytes_of(record.rapid_statement)) : "RAPID");
}

// Returns the positions before `move`, with a RAPID for each further one, because RAPID holds for only one motion. The
// move itself gets a RAPID if it becomes a rapid move.
std::string CorrectedWriter::insertions(std::size_t move) {
  const MotionRecord& record = records_[move];
  const bool is_rapid = path_.moves[move].kind != MoveKind::feed && runs_rapid(path_.moves[move]);
  bool is_rapid_pending = record.is_rapid;
  std::string text;
  if (changes_[move] == nullptr) return text;
  const PathChange& change = *changes_[move];
  for (std::size_t k = 0; k < change.inserted_before.size(); ++k) {
    const Pose& pose = change.inserted_before[k];
    if (!change.inserted_arcs.empty()) text += inserted_arcs_[k];
    if ((is_rapid && !is_rapid_pending) || change.is_at_rapid(k)) text += rapid_line(record);
    is_rapid_pending = false;
    const bool is_template =
        record.form == PositionForm::go_to && record.points == 1 && replaced_.begins_with(record.statement, "GOTO");
    const WrittenPosition position = written(record, record.frame->to_part.inverse().pose(pose), is_axis_kept(record));
    text +=
        framed(record, position,
               is_template ? goto_text_.with_line_end(goto_text_.replaced(record.statement, record.numbers, {position}))
                           : goto_text_.fresh(position));
  }
  const bool is_rapid_spent = record.is_rapid && changes_.has_insertion(move);
  if (is_rapid_spent || change.is_end_at_rapid()) text += rapid_line(record);
  return text;
}

std::string CorrectedWriter::in_place(std::size_t first, std::size_t last) {
  const MotionRecord& record = records_[first];
  const Vec3 axis_before = axis_written_;
  const std::string text = changes_.has_new_arc(first) ? std::string() : insertions(first);
  std::vector<std::optional<WrittenPosition>> positions(last - first);
  bool has_new_axis = false;
  for (std::size_t i = first; i < last; ++i) {
    WrittenPosition position = written(records_[i], local_end(i), record.numbers == 6);
    has_new_axis = has_new_axis || (record.numbers == 3 && position.axis);
    positions[i - first] = position;
  }
  if (has_new_axis && record.points > 1) {
    axis_written_ = axis_before;
    return one_by_one(first, last);
  }
  return text + framed(record, *positions[0], goto_text_.replaced(record.statement, record.numbers, positions));
}

std::string CorrectedWriter::one_by_one(std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t i = first; i < last; ++i) {
    if (i > first && records_[i].form == PositionForm::unread) continue;  // another reading of the previous move
    text += insertions(i);
    const WrittenPosition position = written(records_[i], local_end(i), is_axis_kept(records_[i]));
    text += framed(records_[i], position, goto_text_.fresh(position));
  }
  return text;
}

// If the written text agrees with the file, the axis in force is the one that the file states.
void CorrectedWriter::begin_statement(const MotionRecord& record, bool is_new_block) {
  if (is_new_block || goto_text_.is_same_axis(axis_written_, axis_read_)) axis_written_ = record.implied_axis_local;
}

// Finds moves without a position of their own, and arcs and cycles that stay unchanged although the position before them
// changes.
std::optional<Diagnostic> CorrectedWriter::find_stuck(std::size_t first, std::size_t last) const {
  const MotionRecord& record = records_[first];
  if (record.form == PositionForm::unread) {
    return make_error("write-move", "the statement repeats other moves (COPY); correct those that it repeats",
                      path_.file, path_.moves[first].line);
  }
  if (has_curve_left(first, last)) {
    return make_error("write-arc", "an arc that stays begins where a change ends; straighten it as well", path_.file,
                      path_.moves[first].line);
  }
  const bool is_curve =
      record.form == PositionForm::curve && !changes_.is_straightened(first) && !changes_.has_new_arc(first);
  const bool relies_on_axis =
      keeps_axis(record) && record.numbers == 3 && !goto_text_.is_same_axis(record.implied_axis_local, axis_written_);
  const bool is_cycle = record.form == PositionForm::cycle && (record.numbers == 0 || relies_on_axis);
  if (!is_curve && !is_cycle) return std::nullopt;
  return make_error("write-arc",
                    "a curve or cycle follows a position it takes its axis or its position from; keep that position",
                    path_.file, path_.moves[first].line);
}

// Returns the text of a statement's positions.
std::string CorrectedWriter::rewritten(std::size_t first, std::size_t last) {
  const MotionRecord& record = records_[first];
  if (record.form == PositionForm::cycle) {
    axis_written_ = axis_read_;
    return shifted_holes(first, last);
  }
  if (changes_.has_new_arc(first)) {
    if (record.form != PositionForm::curve) return in_place(first, last);
    axis_written_ = local_end(first).axis;
    return replaced_[record.statement];
  }
  bool is_split = record.form == PositionForm::godlta || record.form == PositionForm::curve;
  for (std::size_t i = first; i < last; ++i) {
    const bool has_own_word = changes_.has_insertion(i) || (changes_[i] != nullptr && changes_[i]->is_end_at_rapid());
    is_split = is_split || (record.points > 1 && has_own_word);
  }
  return is_split ? one_by_one(first, last) : in_place(first, last);
}

std::string CorrectedWriter::shifted_holes(std::size_t first, std::size_t last) const {
  const MotionRecord& record = records_[first];
  std::vector<Vec3> shifts(record.points, Vec3::Zero());
  for (std::size_t i = first; i < last; ++i) {
    if (changes_[i] == nullptr || !changes_[i]->hole_shift_mm) continue;
    shifts[records_[i].point] =
        record.frame->to_part.inverse().direction(*changes_[i]->hole_shift_mm) / record.frame->mm_per_unit;
  }
  return goto_text_.shifted(record.statement, record.numbers, shifts);
}

std::optional<Diagnostic> CorrectedWriter::find_unwritable() const {
  std::optional<RewritableMoves> can;
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    if (!changes_.is_rewritten(i)) continue;
    if (!can) can = rewritable_moves(path_, read_, arc_text_);
    const bool is_split = !changes_[i]->inserted_arcs.empty();
    if (is_split ? can->split[i] : changes_[i]->new_arc ? can->arc[i] : can->hole[i]) continue;
    return make_error("write-arc",
                      "move " + std::to_string(i) +
                          (changes_[i]->has_arc() ? " is no arc whose statement can be rewritten; straighten it instead"
                                                  : " does not begin a hole whose position can be rewritten; leave it"),
                      path_.file, path_.moves[i].line);
  }
  return std::nullopt;
}

Result<Edits> CorrectedWriter::edits() {
  if (auto error = find_unwritable()) return std::move(*error);
  Edits edits;
  std::size_t edited = 0;
  for (std::size_t first = 0, last = 0; first < records_.size(); first = last) {
    const MotionRecord& record = records_[first];
    last = first + 1;
    while (last < records_.size() && records_[last].statement == record.statement) ++last;
    begin_statement(record, first == 0 || record.block != records_[first - 1].block);
    axis_read_ = records_[last - 1].axis_local;
    if (record.numbers != 0) is_axis_usual_ = record.numbers == 6;
    if (!needs_rewriting(first, last)) {
      if (record.numbers == 6 || goto_text_.is_same_axis(axis_written_, record.implied_axis_local))
        axis_written_ = axis_read_;
      continue;
    }
    if (auto error = find_stuck(first, last)) return std::move(*error);
    if (changes_[first] != nullptr && !changes_[first]->inserted_arcs.empty()) {
      if (auto error = describe_inserted_arcs(first)) return std::move(*error);
    }
    if (changes_.has_new_arc(first)) {
      if (auto error = redescribe_arc(first)) return std::move(*error);
    }
    const SourceStatement& span = path_.statements[record.statement];
    replaced_.append_edits(edits, edited, span.first_byte);
    edited = span.last_byte;
    edits.push_back({span.first_byte, span.last_byte, rewritten(first, last)});
  }
  replaced_.append_edits(edits, edited, path_.source.size());
  return edits;
}

}  // namespace

Result<Edits> edits_of_text(const Toolpath& path, const MotionRecords& records,
                            const std::vector<PathChange>& changes) {
  return CorrectedWriter(path, records, changes).edits();
}

}  // namespace gouge
