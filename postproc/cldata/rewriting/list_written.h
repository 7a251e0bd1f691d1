#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

enum class WrittenKind { changed, added, removed };
[[nodiscard]] const char* written_name(WrittenKind kind);

/// A statement of a corrected file that differs from the original.
struct WrittenStatement {
  WrittenKind kind = WrittenKind::changed;
  std::size_t line = 0;  ///< in the original file; for an added statement in the corrected file
  /// index of the statement in each file; kNone: it is not there, or the file is binary
  std::size_t before = kNone, after = kNone;
};

/// Returns every statement by which the bytes of the two files differ, in order. All others are equal to the byte and
/// have the same order.
///
/// Requires `after` as read from the output of write_corrected for `before` and `changes`. In binary NCCS files, whose
/// records are divided differently after an insertion, the result has the records of the changed moves.
/// Cost     O(statements), and O(n m) if n statements between two moves became m others.
[[nodiscard]] std::vector<WrittenStatement> list_written(const Toolpath& before, const std::vector<PathChange>& changes,
                                                         const Toolpath& after);

/// The bytes of changed moves in the original file and in the corrected one. They are the statement of the position,
/// and every statement beside it that was changed, added or removed. Examples are RAPID and MULTAX before an inserted
/// position, and the CIRCLE of an arc that became straight.
class RecordTexts {
 public:
  /// `written` is the result of list_written for these arguments. All must outlive the object and the views that it
  /// returns.
  RecordTexts(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
              const std::vector<WrittenStatement>& written);

  /// Returns the original text of a move. Returns nothing for binary records (NCCS), whose bytes are not text, and for
  /// moves without a statement.
  [[nodiscard]] std::optional<std::string_view> before(std::size_t move) const;
  /// Returns the text of the k-th position inserted before the end of `move`. The end itself follows the last of them.
  [[nodiscard]] std::optional<std::string_view> after(std::size_t move, std::size_t k) const;
  /// Returns the text of all positions that replace the move.
  [[nodiscard]] std::optional<std::string_view> after(std::size_t move) const;

 private:
  struct File {
    const Toolpath* path = nullptr;
    std::vector<bool> is_written;  // for each statement
  };
  /// Returns the text of moves [first, last) of a file.
  [[nodiscard]] std::optional<std::string_view> text_of(const File& file, std::size_t first, std::size_t last) const;

  File before_, after_;
  std::vector<std::size_t> first_;     // for each move, the first move of the corrected path that replaces it
  std::vector<std::size_t> inserted_;  // number of positions inserted, for each move
  bool is_text_ = true;
};

}  // namespace gouge
