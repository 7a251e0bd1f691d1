#pragma once

#include <cstddef>
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

/// Every statement by whose bytes the two files differ, in order; all others are the same to the byte and in the same
/// order.
///
/// Requires `after` as read from what write_corrected made of `before` and `changes`. In binary NCCS files, whose
/// records break at other points once one is added, these are the records of the changed moves.
/// Cost     O(statements), and O(n m) where n statements between two moves became m others.
[[nodiscard]] std::vector<WrittenStatement> list_written(const Toolpath& before, const std::vector<PathChange>& changes,
                                                         const Toolpath& after);

}  // namespace gouge
