#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/rewriting/list_written.h"

namespace gouge {

/// The bytes that changed moves have in the file as it was and in the corrected one: the statement of the position, and
/// with it what was changed, added or removed right beside it (RAPID and MULTAX before an inserted position, the CIRCLE
/// of an arc that became straight).
class RecordTexts {
 public:
  /// `written` as list_written gives it for these. All must outlive the object and the views it gives.
  RecordTexts(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
              const std::vector<WrittenStatement>& written);

  /// Of a move as it was. Nothing for binary records (NCCS), whose bytes are no text, and for moves without a
  /// statement.
  [[nodiscard]] std::optional<std::string_view> before(std::size_t move) const;
  /// Of the k-th position inserted before the end of `move`; the end itself stands behind the last of them.
  [[nodiscard]] std::optional<std::string_view> after(std::size_t move, std::size_t k) const;
  /// Of all that the move became.
  [[nodiscard]] std::optional<std::string_view> after(std::size_t move) const;

 private:
  struct File {
    const Toolpath* path = nullptr;
    std::vector<bool> is_written;  // by statement
  };
  /// Of moves [first, last) of a file.
  [[nodiscard]] std::optional<std::string_view> text_of(const File& file, std::size_t first, std::size_t last) const;

  File before_, after_;
  std::vector<std::size_t> first_;     // of the corrected path: the first move that each move became
  std::vector<std::size_t> inserted_;  // by move
  bool is_text_ = true;
};

}  // namespace gouge
