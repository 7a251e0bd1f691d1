#include "postproc/cldata/rewriting/record_texts.h"

#include "postproc/cldata/language/dialect.h"

namespace gouge {
namespace {

// What the writer closes the frame of a position with an axis with.
bool closes_a_frame(const Toolpath& path, std::size_t statement) {
  const SourceStatement& span = path.statements[statement];
  const std::string_view bytes =
      std::string_view(path.source).substr(span.first_byte, span.last_byte - span.first_byte);
  return bytes.starts_with("MULTAX/OFF");
}

}  // namespace

RecordTexts::RecordTexts(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
                         const std::vector<WrittenStatement>& written)
    : before_{&before, std::vector<bool>(before.statements.size(), false)},
      after_{&after, std::vector<bool>(after.statements.size(), false)},
      first_(before.moves.size(), 0),
      inserted_(before.moves.size(), 0),
      is_text_(!dialect_or_apt(before.dialect).is_binary) {
  for (const WrittenStatement& statement : written) {
    if (statement.before != kNone) before_.is_written[statement.before] = true;
    if (statement.after != kNone) after_.is_written[statement.after] = true;
  }
  for (const PathChange& change : changes) inserted_[change.move] = change.inserted_before.size();
  std::size_t next = 0;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    first_[i] = next;
    next += inserted_[i] + 1;
  }
}

std::optional<std::string_view> RecordTexts::before(std::size_t move) const { return text_of(before_, move, move + 1); }

std::optional<std::string_view> RecordTexts::after(std::size_t move, std::size_t k) const {
  return text_of(after_, first_[move] + k, first_[move] + k + 1);
}

std::optional<std::string_view> RecordTexts::after(std::size_t move) const {
  return text_of(after_, first_[move], first_[move] + inserted_[move] + 1);
}

// What is written stands before its position, but for what closes its frame (MULTAX/OFF).
std::optional<std::string_view> RecordTexts::text_of(const File& file, std::size_t first, std::size_t last) const {
  const Toolpath& path = *file.path;
  if (!is_text_ || last > path.moves.size()) return std::nullopt;
  std::size_t begin = path.moves[first].statement, end = path.moves[last - 1].statement;
  if (begin == kNone || end == kNone || begin > end) return std::nullopt;
  const std::size_t floor =
      first > 0 && path.moves[first - 1].statement != kNone ? path.moves[first - 1].statement + 1 : 0;
  const std::size_t ceiling = last < path.moves.size() && path.moves[last].statement != kNone
                                  ? std::size_t{path.moves[last].statement}
                                  : path.statements.size();
  while (begin > floor && file.is_written[begin - 1] && !closes_a_frame(path, begin - 1)) --begin;
  std::size_t behind = end + 1;
  while (behind < ceiling && file.is_written[behind]) ++behind;
  // Where all up to a next position that is written too is written, it belongs to that, but for the end of a frame.
  const bool is_of_next = behind == ceiling && ceiling < path.statements.size() && file.is_written[ceiling];
  while (end + 1 < behind && (!is_of_next || closes_a_frame(path, end + 1))) ++end;
  const std::size_t from = path.statements[begin].first_byte, to = path.statements[end].last_byte;
  return std::string_view(path.source).substr(from, to - from);
}

}  // namespace gouge
