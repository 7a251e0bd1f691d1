#include "postproc/cldata/write_corrected.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "postproc/cldata/goto_text.h"
#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/write_corrected_nccs.h"

namespace gouge {
namespace {

std::optional<Diagnostic> check_changes(const Toolpath& path, const std::vector<PathChange>& changes) {
  std::vector<bool> is_named(path.moves.size(), false);
  for (const PathChange& change : changes) {
    const std::string name = "move " + std::to_string(change.move);
    if (change.move >= path.moves.size() || is_named[change.move]) {
      return make_error("write-move",
                        name + " is " +
                            (change.move >= path.moves.size() ? "not in the path" : "named twice") +
                            "; expected one change for a move of the path",
                        path.file);
    }
    is_named[change.move] = true;
    const Move& move = path.moves[change.move];
    const bool is_straight = move.kind == MoveKind::feed || move.kind == MoveKind::rapid;
    if (!is_straight && (change.new_end || !change.inserted_before.empty())) {
      return make_error("write-arc",
                        name + " is an arc, a curve or a cycle; only straight moves can be changed",
                        path.file, move.line);
    }
    if (!move.start && !change.inserted_before.empty()) {
      return make_error("write-alone", name + " has no start; positions can be inserted only into a motion",
                        path.file, move.line);
    }
  }
  return std::nullopt;
}

class CorrectedWriter {
 public:
  CorrectedWriter(const Toolpath& path, const std::vector<PathChange>& changes)
      : path_(path),
        records_(read_motion_records(path)),
        goto_text_(path, records_),
        is_axis_modal_(dialect_called(path.dialect).value_or(Dialect{}).is_axis_modal),
        changes_(path.moves.size(), nullptr) {
    for (const PathChange& change : changes) changes_[change.move] = &change;
  }

  Result<std::string> write();

 private:
  [[nodiscard]] bool is_changed(std::size_t move) const {
    return changes_[move] != nullptr && (changes_[move]->new_end || !changes_[move]->inserted_before.empty());
  }
  [[nodiscard]] bool has_insertion(std::size_t move) const {
    return changes_[move] != nullptr && !changes_[move]->inserted_before.empty();
  }
  [[nodiscard]] Pose local_end(std::size_t move) const;
  void begin_statement(const MotionRecord& record, bool is_new_block);
  [[nodiscard]] bool needs_rewriting(std::size_t first, std::size_t last) const;
  [[nodiscard]] WrittenPosition written(const MotionRecord& record, const Pose& local, bool is_axis_kept);
  [[nodiscard]] std::string rapid_line(const MotionRecord& record) const;
  [[nodiscard]] std::string insertions(std::size_t move);
  [[nodiscard]] std::string in_place(std::size_t first, std::size_t last);
  [[nodiscard]] std::string one_by_one(std::size_t first, std::size_t last);
  [[nodiscard]] std::string framed(const MotionRecord& record, const WrittenPosition& position,
                                   std::string text) const;

  const Toolpath& path_;
  std::vector<MotionRecord> records_;
  GotoText goto_text_;
  bool is_axis_modal_;
  std::vector<const PathChange*> changes_;
  Vec3 axis_read_ = Vec3::UnitZ();     // the modal axis after the last position of the file read so far
  Vec3 axis_written_ = Vec3::UnitZ();  // the same for the text written so far
};

// The end of `move` in its statement's frame, in mm.
Pose CorrectedWriter::local_end(std::size_t move) const {
  const Pose& end =
      changes_[move] != nullptr && changes_[move]->new_end ? *changes_[move]->new_end : path_.moves[move].end;
  return records_[move].to_part.inverse().pose(end);
}

bool CorrectedWriter::needs_rewriting(std::size_t first, std::size_t last) const {
  for (std::size_t i = first; i < last; ++i) {
    if (is_changed(i)) return true;
  }
  const MotionRecord& record = records_[first];
  if (record.form == PositionForm::godlta) {
    return first > 0 && changes_[first - 1] != nullptr && changes_[first - 1]->new_end.has_value();
  }
  if (record.form == PositionForm::unread) return false;
  const bool relies_on_axis = is_axis_modal_ && (record.numbers == 3 || record.form == PositionForm::curve);
  return relies_on_axis && !goto_text_.is_same_axis(record.implied_axis_local, axis_written_);
}

// What to write for `local`, and the axis it leaves in force. The axis is left out where 3 numbers mean the
// same.
WrittenPosition CorrectedWriter::written(const MotionRecord& record, const Pose& local, bool is_axis_kept) {
  WrittenPosition position;
  position.tip = local.tip / record.mm_per_unit;
  const Vec3& implied = is_axis_modal_ ? axis_written_ : record.implied_axis_local;
  if (is_axis_kept || !goto_text_.is_same_axis(local.axis, implied)) position.axis = local.axis;
  axis_written_ = local.axis;
  return position;
}

// Under MULTAX/OFF six numbers are two positions, so a position with an axis switches it on for itself.
std::string CorrectedWriter::framed(const MotionRecord& record, const WrittenPosition& position,
                                    std::string text) const {
  if (!record.is_multax_off || !position.axis || record.numbers == 6) return text;
  return goto_text_.with_line_end("MULTAX/ON") + goto_text_.with_line_end(std::move(text)) +
         goto_text_.with_line_end("MULTAX/OFF");
}

std::string CorrectedWriter::rapid_line(const MotionRecord& record) const {
  if (record.rapid_statement == kNone) return goto_text_.with_line_end("RAPID");
  const SourceStatement& span = path_.statements[record.rapid_statement];
  if (span.first_byte == span.last_byte) return {};  // NCI: the code of the position says it
  return goto_text_.with_line_end(path_.source.substr(span.first_byte, span.last_byte - span.first_byte));
}

// The positions to visit before `move`, and, as RAPID holds for one motion only, a RAPID for each further
// one.
std::string CorrectedWriter::insertions(std::size_t move) {
  const MotionRecord& record = records_[move];
  const bool is_rapid = path_.moves[move].kind == MoveKind::rapid;
  bool is_rapid_pending = record.is_rapid;
  std::string text;
  if (!has_insertion(move)) return text;
  for (const Pose& pose : changes_[move]->inserted_before) {
    if (is_rapid && !is_rapid_pending) text += rapid_line(record);
    is_rapid_pending = false;
    const bool is_template = record.form == PositionForm::go_to && record.points == 1;
    const WrittenPosition position =
        written(record, record.to_part.inverse().pose(pose), record.numbers == 6);
    text += framed(record, position,
                   is_template ? goto_text_.with_line_end(
                                     goto_text_.replaced(record.statement, record.numbers, {position}))
                               : goto_text_.fresh(position));
  }
  if (record.is_rapid) text += rapid_line(record);
  return text;
}

std::string CorrectedWriter::in_place(std::size_t first, std::size_t last) {
  const MotionRecord& record = records_[first];
  const std::string text = insertions(first);
  std::vector<std::optional<WrittenPosition>> positions(last - first);
  bool has_new_axis = false;
  for (std::size_t i = first; i < last; ++i) {
    WrittenPosition position = written(records_[i], local_end(i), record.numbers == 6);
    has_new_axis = has_new_axis || (record.numbers == 3 && position.axis);
    positions[i - first] = position;
  }
  if (has_new_axis && record.points > 1) return one_by_one(first, last);
  return text +
         framed(record, *positions[0], goto_text_.replaced(record.statement, record.numbers, positions));
}

std::string CorrectedWriter::one_by_one(std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t i = first; i < last; ++i) {
    text += insertions(i);
    const WrittenPosition position = written(records_[i], local_end(i), records_[i].numbers == 6);
    text += framed(records_[i], position, goto_text_.fresh(position));
  }
  return text;
}

// Where the text written agrees with the file read, the axis in force is the one the file says is in force.
void CorrectedWriter::begin_statement(const MotionRecord& record, bool is_new_block) {
  if (is_new_block || goto_text_.is_same_axis(axis_written_, axis_read_))
    axis_written_ = record.implied_axis_local;
}

Result<std::string> CorrectedWriter::write() {
  const std::string_view source = path_.source;
  std::string result;
  result.reserve(source.size() + source.size() / 8);
  std::size_t copied = 0;
  for (std::size_t first = 0, last = 0; first < records_.size(); first = last) {
    const MotionRecord& record = records_[first];
    last = first + 1;
    while (last < records_.size() && records_[last].statement == record.statement) ++last;
    begin_statement(record, first == 0 || record.block != records_[first - 1].block);
    axis_read_ = records_[last - 1].axis_local;
    if (!needs_rewriting(first, last)) {
      if (record.numbers == 6 || goto_text_.is_same_axis(axis_written_, record.implied_axis_local))
        axis_written_ = axis_read_;
      continue;
    }
    if (record.form == PositionForm::curve) {
      return make_error(
          "write-arc",
          "a curve follows a position with another axis, which it would take over; keep that axis",
          path_.file, path_.moves[first].line);
    }
    const SourceStatement& span = path_.statements[record.statement];
    result += source.substr(copied, span.first_byte - copied);
    copied = span.last_byte;
    bool is_split = record.form == PositionForm::godlta;
    for (std::size_t i = first; i < last; ++i) is_split = is_split || (record.points > 1 && has_insertion(i));
    result += is_split ? one_by_one(first, last) : in_place(first, last);
  }
  result += source.substr(copied);
  return result;
}

}  // namespace

Result<std::string> write_corrected(const Toolpath& path, const std::vector<PathChange>& changes) {
  if (auto error = check_changes(path, changes)) return std::move(*error);
  if (path.dialect == dialect_of(DialectKind::nccs_binary).id) return write_corrected_nccs(path, changes);
  return CorrectedWriter(path, changes).write();
}

}  // namespace gouge
