#pragma once

#include <cstddef>
#include <memory>

#include "postproc/cldata/language/statement.h"

namespace gouge {

/// Number of statements that pass from one thread to the other at once.
inline constexpr std::size_t kStatementsAtOnce = 256;

/// Returns the statements of `source` in the same order. A thread of its own reads them ahead of the caller and splits the
/// arguments of positions. If the system refuses the thread, the caller reads them. An exception of `source` reaches the
/// caller. Requires at_once > 0.
[[nodiscard]] std::unique_ptr<StatementSource> read_ahead(std::unique_ptr<StatementSource> source,
                                                          std::size_t at_once = kStatementsAtOnce);

}  // namespace gouge
