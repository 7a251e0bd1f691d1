#include "postproc/cldata/nccs/nccs_edits.h"

#include <algorithm>

#include "lib/path/run_kind.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/nccs/nccs_records.h"
#include "postproc/cldata/rewriting/change_table.h"

namespace gouge {
namespace {

class NccsCorrector {
 public:
  NccsCorrector(const Toolpath& path, const MotionRecords& records, const std::vector<PathChange>& changes)
      : path_(path),
        source_(path.source),
        read_(records),
        records_(read_.of_move),
        changes_(path.moves.size(), changes) {}

  Result<Edits> edits();

 private:
  [[nodiscard]] std::string laid_out() const;
  [[nodiscard]] Edits changed_words() const;
  [[nodiscard]] std::size_t first_word_of(std::size_t statement) const {
    return NccsWords::word_at(path_.statements[statement].first_byte);
  }
  void drop_circles();
  [[nodiscard]] std::optional<Diagnostic> find_broken_arc() const;
  [[nodiscard]] bool needs_own_circle(std::size_t move) const;
  [[nodiscard]] bool needs_rewriting(std::size_t first, std::size_t last) const;
  [[nodiscard]] static bool is_implied(const MotionRecord& record, const Vec3& axis);
  void note_axis(const MotionRecord& record, const Vec3& axis);
  [[nodiscard]] bool is_split(std::size_t first, std::size_t last, const NccsHeader& header) const;
  [[nodiscard]] Pose local_end(std::size_t move) const;
  [[nodiscard]] std::string numbers(const MotionRecord& record, const Pose& local, bool with_axis) const;
  void copy(std::size_t first_word, std::size_t last_word);
  /// Copies source words without the circles that are dropped. Every call must be for later words than the previous
  /// one.
  void copy_source(std::size_t first_word, std::size_t last_word);
  void add(std::uint16_t klass, std::uint16_t subclass, std::uint16_t sequence, const std::string& words);
  void add_position(const MotionRecord& record, const Pose& local, std::uint16_t sequence);
  void add_insertions(std::size_t move, std::uint16_t sequence);
  void copy_point(std::size_t move, const NccsHeader& header);
  void rewrite(std::size_t first, std::size_t last, const NccsHeader& header);
  void split(std::size_t first, std::size_t last, const NccsHeader& header);

  const Toolpath& path_;
  NccsWords source_;
  const MotionRecords& read_;
  const std::vector<MotionRecord>& records_;  // the records in read_
  ChangeTable changes_;
  std::vector<std::size_t> dropped_;  // statements of circles whose arcs become straight, in order
  std::size_t next_dropped_ = 0;      // index of the next of these that was not yet passed
  bool has_new_tilt_ = false;         // the last written axis is tilted, and three numbers after it would be uncertain
  std::string words_;
};

void NccsCorrector::drop_circles() {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (changes_.is_straightened(i) && records_[i].curve_statement != kNone)
      dropped_.push_back(records_[i].curve_statement);
  }
  std::sort(dropped_.begin(), dropped_.end());
  dropped_.erase(std::unique(dropped_.begin(), dropped_.end()), dropped_.end());
}

// Finds an arc that stays although the position at its beginning changes.
std::optional<Diagnostic> NccsCorrector::find_broken_arc() const {
  for (std::size_t i = 1; i < records_.size(); ++i) {
    const Move& move = path_.moves[i];
    if (move.kind != MoveKind::arc || changes_.is_straightened(i) || !move.has_start || !changes_.has_new_end(i - 1))
      continue;
    return make_error("write-arc", "an arc that stays begins where a change ends; straighten it as well", path_.file,
                      move.line);
  }
  return std::nullopt;
}

// Returns whether a move is an arc that stays, on a circle of which other arcs become straight. A list may begin with a
// position that is not on an arc.
bool NccsCorrector::needs_own_circle(std::size_t move) const {
  const Move& m = path_.moves[move];
  const bool is_round = m.curve_kind != CurveKind::none || !is_motion_known(m.not_checked_reason);
  return m.kind == MoveKind::arc && is_round && !changes_.is_straightened(move) &&
         std::binary_search(dropped_.begin(), dropped_.end(), records_[move].curve_statement);
}

Pose NccsCorrector::local_end(std::size_t move) const {
  return records_[move].frame->to_part.inverse().pose(changes_.has_new_end(move) ? *changes_[move]->new_end
                                                                                 : path_.moves[move].end);
}

bool NccsCorrector::needs_rewriting(std::size_t first, std::size_t last) const {
  for (std::size_t i = first; i < last; ++i) {
    // If it stayed unchanged, a continuation would run along a circle that is put before the positions it continues.
    if (changes_.has_new_end(i) || changes_.has_insertion(i) || changes_.is_straightened(i) || needs_own_circle(i))
      return true;
  }
  if (has_new_tilt_ && records_[first].form == PositionForm::go_to && records_[first].numbers == 3) return true;
  return records_[first].form == PositionForm::godlta && first > 0 && changes_.has_new_end(first - 1);
}

bool NccsCorrector::is_implied(const MotionRecord& record, const Vec3& axis) {
  return (axis - record.implied_axis_local).cwiseAbs().maxCoeff() <= kSameNccsAxis;
}

// Notes the axis of a position that was written with one. After an axis that was tilted in the file too, three numbers
// stay uncertain.
void NccsCorrector::note_axis(const MotionRecord& record, const Vec3& axis) {
  has_new_tilt_ = !is_implied(record, axis) && is_implied(record, record.axis_local);
}

std::string NccsCorrector::numbers(const MotionRecord& record, const Pose& local, bool with_axis) const {
  std::string text;
  for (Eigen::Index i = 0; i < 3; ++i) text += nccs_word(local.tip[i] / record.frame->mm_per_unit);
  for (Eigen::Index i = 0; with_axis && i < 3; ++i) text += nccs_word(local.axis[i]);
  return text;
}

void NccsCorrector::copy(std::size_t first_word, std::size_t last_word) {
  for (std::size_t word = first_word; word < last_word; ++word) words_ += source_.bytes(word);
}

void NccsCorrector::copy_source(std::size_t first_word, std::size_t last_word) {
  for (; next_dropped_ < dropped_.size(); ++next_dropped_) {
    const std::size_t circle = first_word_of(dropped_[next_dropped_]);
    if (circle >= last_word) break;
    copy(first_word, circle);
    first_word = circle + source_.header(circle).words;
  }
  copy(first_word, last_word);
}

void NccsCorrector::add(std::uint16_t klass, std::uint16_t subclass, std::uint16_t sequence, const std::string& words) {
  words_ +=
      nccs_word(NccsHeader{static_cast<std::uint16_t>(1 + words.size() / kNccsWordBytes), klass, subclass, sequence});
  words_ += words;
}

// Adds a position, with its axis if three numbers have, or may have, another one. Without MULTAX a position with an axis
// would be two positions, so MULTAX is switched on for this one.
void NccsCorrector::add_position(const MotionRecord& record, const Pose& local, std::uint16_t sequence) {
  const bool is_uncertain = !is_implied(record, local.axis) || has_new_tilt_;
  const bool has_axis = record.numbers == 6 || (record.numbers == 0 && !record.is_multax_off) || is_uncertain;
  const bool is_expanded = source_.header(first_word_of(record.statement)).klass == NccsClass::kExpanded;
  const bool is_switched = record.is_multax_off && has_axis && (record.numbers != 6 || is_expanded);
  if (is_switched) add(NccsClass::kMode, NccsSubclass::kMultaxOn, sequence, {});
  add(NccsClass::kMotion, NccsSubclass::kPoints, sequence, numbers(record, local, has_axis));
  if (is_switched) add(NccsClass::kMode, NccsSubclass::kMultaxOff, sequence, {});
  if (has_axis) note_axis(record, local.axis);
}

void NccsCorrector::add_insertions(std::size_t move, std::uint16_t sequence) {
  const MotionRecord& record = records_[move];
  if (!changes_.has_insertion(move)) return;
  const bool is_rapid = path_.moves[move].kind != MoveKind::feed && runs_rapid(path_.moves[move]);
  bool is_pending = record.is_rapid;
  for (const Pose& pose : changes_[move]->inserted_before) {
    if (is_rapid && !is_pending) add(NccsClass::kPost, NccsSubclass::kRapid, sequence, {});
    is_pending = false;
    add_position(record, record.frame->to_part.inverse().pose(pose), sequence);
  }
  if (record.is_rapid) add(NccsClass::kPost, NccsSubclass::kRapid, sequence, {});
}

// Copies a point as a record of its own.
void NccsCorrector::copy_point(std::size_t move, const NccsHeader& header) {
  const MotionRecord& record = records_[move];
  const bool is_expanded = header.klass == NccsClass::kExpanded;
  const std::size_t count = is_expanded ? kNccsExpandedWords : record.numbers;
  const std::size_t begin = first_word_of(record.statement) + 1 + record.point * count;
  words_ += nccs_word(
      NccsHeader{static_cast<std::uint16_t>(1 + count), header.klass, NccsSubclass::kPoints, header.sequence});
  copy(begin, begin + count);
  if (record.numbers != 3) note_axis(record, record.axis_local);
}

bool NccsCorrector::is_split(std::size_t first, std::size_t last, const NccsHeader& header) const {
  if (records_[first].form == PositionForm::godlta || header.klass == NccsClass::kExpanded) return true;
  for (std::size_t i = first; i < last; ++i) {
    const bool is_new_axis = records_[i].numbers == 3 && (has_new_tilt_ || !is_implied(records_[i], local_end(i).axis));
    if (is_new_axis || changes_.has_insertion(i) || changes_.is_straightened(i) || needs_own_circle(i)) return true;
  }
  return false;
}

void NccsCorrector::split(std::size_t first, std::size_t last, const NccsHeader& header) {
  for (std::size_t i = first; i < last; ++i) {
    add_insertions(i, header.sequence);
    if (needs_own_circle(i)) {
      const std::size_t circle = first_word_of(records_[i].curve_statement);
      copy(circle, circle + source_.header(circle).words);
    }
    const bool is_stale = header.klass == NccsClass::kExpanded && changes_.has_insertion(i);
    const bool is_uncertain = has_new_tilt_ && records_[i].numbers == 3;
    if (records_[i].form == PositionForm::go_to && !changes_.has_new_end(i) && !is_stale && !is_uncertain) {
      copy_point(i, header);
    } else {
      add_position(records_[i], local_end(i), header.sequence);
    }
  }
}

void NccsCorrector::rewrite(std::size_t first, std::size_t last, const NccsHeader& header) {
  if (is_split(first, last, header)) return split(first, last, header);
  const std::size_t begin = first_word_of(records_[first].statement);
  words_ += source_.bytes(begin);
  for (std::size_t i = first; i < last; ++i) {
    if (changes_.has_new_end(i)) {
      words_ += numbers(records_[i], local_end(i), records_[i].numbers == 6);
    } else {
      const std::size_t from = begin + 1 + records_[i].first_argument;
      copy(from, from + records_[i].numbers);
    }
  }
  if (records_[first].numbers != 3) note_axis(records_[last - 1], local_end(last - 1).axis);
}

// Returns all records in blocks. The zeros that fill the last block are read as damage unless they follow FINI.
std::string NccsCorrector::laid_out() const {
  std::string bytes = nccs_blocks(words_);
  const std::size_t last_record = first_word_of(path_.statements.size() - 1);
  if (source_.header(last_record).klass != NccsClass::kFini)
    bytes.resize(NccsWords::offset(words_.size() / kNccsWordBytes - 1) + kNccsWordBytes);
  return bytes;
}

Edits NccsCorrector::changed_words() const {
  Edits edits;
  for (std::size_t word = 0; word < source_.words(); ++word) {
    const std::string_view now = std::string_view(words_).substr(word * kNccsWordBytes, kNccsWordBytes);
    const std::size_t first = NccsWords::offset(word);
    if (now != source_.bytes(word)) edits.push_back({first, first + kNccsWordBytes, std::string(now)});
  }
  return edits;
}

Result<Edits> NccsCorrector::edits() {
  drop_circles();
  if (auto error = find_broken_arc()) return std::move(*error);
  std::size_t copied = 0;
  for (std::size_t first = 0, last = 0; first < records_.size(); first = last) {
    last = first + 1;
    while (last < records_.size() && records_[last].statement == records_[first].statement) ++last;
    const bool is_hole_by_step = records_[first].form == PositionForm::cycle && records_[first].numbers == 0;
    if (is_hole_by_step && first > 0 && changes_.has_new_end(first - 1)) {
      return make_error("write-arc", "a hole is a step from a position that changes; keep that position", path_.file,
                        path_.moves[first].line);
    }
    if (!needs_rewriting(first, last)) {
      if (records_[first].numbers == 6) has_new_tilt_ = false;
      continue;
    }
    const std::size_t word = first_word_of(records_[first].statement);
    const NccsHeader header = source_.header(word);
    copy_source(copied, word);
    copied = word + header.words;
    rewrite(first, last, header);
  }
  const std::size_t count = source_.words();
  copy_source(copied, count);
  if (words_.size() != count * kNccsWordBytes) return Edits{{0, path_.source.size(), laid_out()}};
  return changed_words();
}

}  // namespace

Result<Edits> edits_of_nccs(const Toolpath& path, const MotionRecords& records,
                            const std::vector<PathChange>& changes) {
  return NccsCorrector(path, records, changes).edits();
}

}  // namespace gouge
