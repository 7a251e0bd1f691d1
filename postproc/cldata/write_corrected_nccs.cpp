#include "postproc/cldata/write_corrected_nccs.h"

#include "postproc/cldata/interpreter.h"
#include "postproc/cldata/nccs_records.h"

namespace gouge {
namespace {

constexpr double kSameAxis = 1e-12;
constexpr std::size_t kWord = 8;
constexpr std::uint16_t kPoints = 5, kRapid = 5, kMultaxOn = 0, kMultaxOff = 1;

class NccsCorrector {
 public:
  NccsCorrector(const Toolpath& path, const std::vector<PathChange>& changes)
      : path_(path),
        source_(path.source),
        read_(read_motion_records(path)),
        records_(read_.of_move),
        changes_(path.moves.size()) {
    for (const PathChange& change : changes) changes_[change.move] = &change;
  }

  std::string run();

 private:
  [[nodiscard]] bool needs_rewriting(std::size_t first, std::size_t last) const;
  [[nodiscard]] Pose local_end(std::size_t move) const;
  [[nodiscard]] std::string numbers(const MotionRecord& record, const Pose& local, bool with_axis) const;
  void copy(std::size_t first_word, std::size_t last_word);
  void add(std::uint16_t klass, std::uint16_t subclass, std::uint16_t sequence, const std::string& words);
  void add_position(const MotionRecord& record, const Pose& local, std::uint16_t sequence);
  void add_insertions(std::size_t move, std::uint16_t sequence);
  void rewrite(std::size_t first, std::size_t last, const NccsHeader& header);

  const Toolpath& path_;
  NccsWords source_;
  MotionRecords read_;
  const std::vector<MotionRecord>& records_;  // of read_
  std::vector<const PathChange*> changes_;
  std::string words_;
};

Pose NccsCorrector::local_end(std::size_t move) const {
  const bool is_new = changes_[move] != nullptr && changes_[move]->new_end;
  return records_[move].frame->to_part.inverse().pose(is_new ? *changes_[move]->new_end : path_.moves[move].end);
}

bool NccsCorrector::needs_rewriting(std::size_t first, std::size_t last) const {
  for (std::size_t i = first; i < last; ++i) {
    if (changes_[i] != nullptr && (changes_[i]->new_end || !changes_[i]->inserted_before.empty()))
      return true;
  }
  return records_[first].form == PositionForm::godlta && first > 0 && changes_[first - 1] != nullptr &&
         changes_[first - 1]->new_end.has_value();
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

void NccsCorrector::add(std::uint16_t klass, std::uint16_t subclass, std::uint16_t sequence,
                        const std::string& words) {
  words_ +=
      nccs_word(NccsHeader{static_cast<std::uint16_t>(1 + words.size() / kWord), klass, subclass, sequence});
  words_ += words;
}

// Without MULTAX a position with an axis would be two positions, so it is switched on for this one.
void NccsCorrector::add_position(const MotionRecord& record, const Pose& local, std::uint16_t sequence) {
  const bool is_new_axis = (local.axis - record.implied_axis_local).cwiseAbs().maxCoeff() > kSameAxis;
  const bool has_axis = record.numbers == 6 || (record.numbers == 0 && !record.is_multax_off) || is_new_axis;
  const bool is_switched = record.is_multax_off && has_axis && record.numbers != 6;
  if (is_switched) add(NccsClass::kMode, kMultaxOn, sequence, {});
  add(NccsClass::kMotion, kPoints, sequence, numbers(record, local, has_axis));
  if (is_switched) add(NccsClass::kMode, kMultaxOff, sequence, {});
}

void NccsCorrector::add_insertions(std::size_t move, std::uint16_t sequence) {
  const MotionRecord& record = records_[move];
  if (changes_[move] == nullptr || changes_[move]->inserted_before.empty()) return;
  const bool is_rapid = path_.moves[move].kind == MoveKind::rapid;
  bool is_pending = record.is_rapid;
  for (const Pose& pose : changes_[move]->inserted_before) {
    if (is_rapid && !is_pending) add(NccsClass::kPost, kRapid, sequence, {});
    is_pending = false;
    add_position(record, record.frame->to_part.inverse().pose(pose), sequence);
  }
  if (record.is_rapid) add(NccsClass::kPost, kRapid, sequence, {});
}

void NccsCorrector::rewrite(std::size_t first, std::size_t last, const NccsHeader& header) {
  bool is_split = records_[first].form == PositionForm::godlta;
  for (std::size_t i = first; i < last; ++i) {
    const bool is_new_axis =
        records_[i].numbers == 3 &&
        (local_end(i).axis - records_[i].implied_axis_local).cwiseAbs().maxCoeff() > kSameAxis;
    is_split = is_split || is_new_axis || (changes_[i] != nullptr && !changes_[i]->inserted_before.empty());
  }
  if (is_split) {
    for (std::size_t i = first; i < last; ++i) {
      add_insertions(i, header.sequence);
      add_position(records_[i], local_end(i), header.sequence);
    }
    return;
  }
  const std::size_t begin = NccsWords::word_at(path_.statements[records_[first].statement].first_byte);
  words_ += source_.bytes(begin);
  for (std::size_t i = first; i < last; ++i) {
    if (changes_[i] != nullptr && changes_[i]->new_end) {
      words_ += numbers(records_[i], local_end(i), records_[i].numbers == 6);
    } else {
      const std::size_t from = begin + 1 + records_[i].first_argument;
      copy(from, from + records_[i].numbers);
    }
  }
}

std::string NccsCorrector::run() {
  std::size_t copied = 0;
  for (std::size_t first = 0, last = 0; first < records_.size(); first = last) {
    last = first + 1;
    while (last < records_.size() && records_[last].statement == records_[first].statement) ++last;
    if (!needs_rewriting(first, last)) continue;
    const std::size_t word = NccsWords::word_at(path_.statements[records_[first].statement].first_byte);
    const NccsHeader header = source_.header(word);
    copy(copied, word);
    copied = word + header.words;
    rewrite(first, last, header);
  }
  const std::size_t count = source_.words();
  copy(copied, count);
  if (words_.size() != count * kWord) return nccs_blocks(words_);
  std::string bytes = path_.source;
  for (std::size_t word = 0; word < count; ++word)
    bytes.replace(NccsWords::offset(word), kWord, words_, word * kWord, kWord);
  return bytes;
}

}  // namespace

std::string write_corrected_nccs(const Toolpath& path, const std::vector<PathChange>& changes) {
  return NccsCorrector(path, changes).run();
}

}  // namespace gouge
