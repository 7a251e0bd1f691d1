#include "postproc/cldata/rewriting/list_written.h"

#include <algorithm>
#include <string_view>

#include "postproc/cldata/language/dialect.h"

namespace gouge {

namespace {

// maximum number of table entries; a larger comparison finds nothing in common
constexpr std::size_t kLargestTable = 1'000'000;

class Comparison {
 public:
  Comparison(const Toolpath& before, const Toolpath& after) : before_(before), after_(after) {}

  std::vector<WrittenStatement> run(const std::vector<PathChange>& changes) {
    std::vector<std::size_t> inserted(before_.moves.size(), 0);
    for (const PathChange& change : changes) inserted[change.move] = change.inserted_before.size();
    std::size_t next = 0;
    for (std::size_t i = 0; i < before_.moves.size(); ++i) {
      next += inserted[i];
      if (next >= after_.moves.size()) break;
      meet(before_.moves[i].statement, after_.moves[next++].statement);
    }
    between(before_.statements.size(), after_.statements.size());
    return std::move(written_);
  }

 private:
  static std::string_view bytes(const Toolpath& path, std::size_t statement) {
    const SourceStatement& span = path.statements[statement];
    return std::string_view(path.source).substr(span.first_byte, span.last_byte - span.first_byte);
  }
  [[nodiscard]] bool is_same(std::size_t a, std::size_t b) const { return bytes(before_, a) == bytes(after_, b); }

  void add(WrittenKind kind, std::size_t before, std::size_t after) {
    const std::size_t line =
        kind == WrittenKind::added ? after_.statements[after].line : before_.statements[before].line;
    written_.push_back({kind, line, before, after});
  }

  /// Handles the statements of one move in both files.
  void meet(std::size_t a, std::size_t b) {
    if (a == kNone || b == kNone || b < next_after_) return;  // a list of positions: its statement was compared already
    if (a < next_before_) {                                   // one statement became several
      between(next_before_, b);
      add(WrittenKind::added, kNone, b);
      next_after_ = b + 1;
      return;
    }
    between(a, b);
    if (!is_same(a, b)) add(WrittenKind::changed, a, b);
    next_before_ = a + 1;
    next_after_ = b + 1;
  }

  /// Compares the statements before `a` and `b`, from those that were compared last.
  void between(std::size_t a, std::size_t b) {
    while (next_before_ < a && next_after_ < b && is_same(next_before_, next_after_)) {
      ++next_before_;
      ++next_after_;
    }
    std::size_t last_before = a, last_after = b;
    while (next_before_ < last_before && next_after_ < last_after && is_same(last_before - 1, last_after - 1)) {
      --last_before;
      --last_after;
    }
    differ(last_before, last_after);
    next_before_ = a;
    next_after_ = b;
  }

  /// Compares the remaining statements by their longest common subsequence.
  void differ(std::size_t a, std::size_t b) {
    const std::size_t n = a - next_before_, m = b - next_after_;
    const bool is_small = n * m <= kLargestTable;
    std::vector<std::size_t> common(is_small ? (n + 1) * (m + 1) : 0, 0);
    const auto at = [&](std::size_t i, std::size_t k) -> std::size_t& { return common[i * (m + 1) + k]; };
    for (std::size_t i = is_small ? n : 0; i-- > 0;) {
      for (std::size_t k = m; k-- > 0;) {
        at(i, k) =
            is_same(next_before_ + i, next_after_ + k) ? at(i + 1, k + 1) + 1 : std::max(at(i + 1, k), at(i, k + 1));
      }
    }
    std::size_t i = 0, k = 0;
    while (i < n || k < m) {
      const bool is_both = i < n && k < m;
      if (is_both && is_small && is_same(next_before_ + i, next_after_ + k)) {
        ++i;
        ++k;
      } else if (k == m || (is_both && is_small && at(i + 1, k) >= at(i, k + 1))) {
        add(WrittenKind::removed, next_before_ + i++, kNone);
      } else {
        add(WrittenKind::added, kNone, next_after_ + k++);
      }
    }
  }

  const Toolpath& before_;
  const Toolpath& after_;
  std::size_t next_before_ = 0, next_after_ = 0;  // the first statements not yet compared
  std::vector<WrittenStatement> written_;
};

std::vector<WrittenStatement> of_changes(const Toolpath& path, const std::vector<PathChange>& changes) {
  std::vector<std::size_t> lines;
  for (const PathChange& change : changes) lines.push_back(path.moves[change.move].line);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  std::vector<WrittenStatement> written;
  for (const std::size_t line : lines) written.push_back({WrittenKind::changed, line, kNone, kNone});
  return written;
}

}  // namespace

const char* written_name(WrittenKind kind) {
  return kind == WrittenKind::changed ? "changed" : kind == WrittenKind::added ? "added" : "removed";
}

std::vector<WrittenStatement> list_written(const Toolpath& before, const std::vector<PathChange>& changes,
                                           const Toolpath& after) {
  if (dialect_or_apt(before.dialect).is_binary) return of_changes(before, changes);
  return Comparison(before, after).run(changes);
}

namespace {

// Returns whether a statement is the one with which the writer closes the frame of a position with an axis.
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

// Returns the text of moves. Written statements precede their position, except the one that closes its frame
// (MULTAX/OFF).
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
  // If all statements up to a written next position are written, they belong to it, except the end of a frame.
  const bool is_of_next = behind == ceiling && ceiling < path.statements.size() && file.is_written[ceiling];
  while (end + 1 < behind && (!is_of_next || closes_a_frame(path, end + 1))) ++end;
  const std::size_t from = path.statements[begin].first_byte, to = path.statements[end].last_byte;
  return std::string_view(path.source).substr(from, to - from);
}

}  // namespace gouge
