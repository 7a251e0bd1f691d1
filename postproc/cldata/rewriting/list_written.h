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

/// A statement of a corrected file that is not as it was.
struct WrittenStatement {
  WrittenKind kind = WrittenKind::changed;
  std::size_t line = 0;                       ///< of the file as it was; of one that was added: of the corrected file
  std::size_t before = kNone, after = kNone;  ///< the statement of each file; kNone: it has none there, or it is binary
};

/// Returns every statement by whose bytes the two files differ, in order; all others are the same to the byte and in
/// the same order.
///
/// Requires `after` as read from what write_corrected made of `before` and `changes`. In binary NCCS files, whose
/// records break at other points once one is added, these are the records of the changed moves.
/// Cost     O(statements), and O(n m) where n statements between two moves became m others.
[[nodiscard]] std::vector<WrittenStatement> list_written(const Toolpath& before, const std::vector<PathChange>& changes,
                                                         const Toolpath& after);

/// The bytes that changed moves have in the file as it was and in the corrected one. They are the statement of the
/// position, and beside it every statement that was changed, added or removed. Examples are RAPID and MULTAX before an
/// inserted position, and the CIRCLE of an arc that became straight.
class RecordTexts {
 public:
  /// `written` as list_written gives it for these. All must outlive the object and the views it gives.
  RecordTexts(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
              const std::vector<WrittenStatement>& written);

  /// Returns the text of a move as it was. Nothing for binary records (NCCS), whose bytes are not text, and for moves
  /// without a statement.
  [[nodiscard]] std::optional<std::string_view> before(std::size_t move) const;
  /// Returns the text of the k-th position inserted before the end of `move`; the end itself stands behind the last of
  /// them.
  [[nodiscard]] std::optional<std::string_view> after(std::size_t move, std::size_t k) const;
  /// Returns the text of all that the move became.
  [[nodiscard]] std::optional<std::string_view> after(std::size_t move) const;

 private:
  struct File {
    const Toolpath* path = nullptr;
    std::vector<bool> is_written;  // by statement
  };
  /// Returns the text of moves [first, last) of a file.
  [[nodiscard]] std::optional<std::string_view> text_of(const File& file, std::size_t first, std::size_t last) const;

  File before_, after_;
  std::vector<std::size_t> first_;     // of the corrected path: the first move that each move became
  std::vector<std::size_t> inserted_;  // by move
  bool is_text_ = true;
};

}  // namespace gouge
