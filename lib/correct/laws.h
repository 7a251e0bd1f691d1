#pragma once

#include <string>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

// Rules that a correction must keep, by the checks of the path before and after it: no move that was clean becomes
// anything else, none becomes deeper, none becomes buried or uncertain.

namespace gouge {

/// Returns whether a motion with verdict `before` may become one with verdict `after`.
///
/// Ensures  True only where `after` is clean, or near where `before` was not clean, or a gouge where `before` was one
///          at least as deep: to twice the resolution, as that is how far both depths are known.
[[nodiscard]] bool is_no_worse_than(const MoveVerdict& before, const MoveVerdict& after, double resolution_mm);

/// A checked path.
struct CheckedPath {
  const Toolpath* path = nullptr;
  const CheckResult* result = nullptr;
};

/// The moves [first, last) of the changed path that a move of the path as it was became: inserted ones, then its own.
struct MovesAfter {
  std::size_t first = 0, last = 0;
};

/// For each move of a path with `moves` moves. The last entry ends at the number of moves of the changed path.
[[nodiscard]] std::vector<MovesAfter> moves_after(std::size_t moves, const std::vector<PathChange>& changes);

/// Moves of the path as it was, in path order, of which `after` is worse than `before` or is not what `changes` states:
/// an unchanged move that is not the same any more, or not as many moves (then all of them). `options`: of both checks.
[[nodiscard]] std::vector<std::size_t> find_worse(const CheckedPath& before, const std::vector<PathChange>& changes,
                                                  const CheckedPath& after, const CheckOptions& options);

}  // namespace gouge
