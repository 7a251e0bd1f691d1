#pragma once

#include <string>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

// Rules that a correction must keep, according to the checks of the path before and after it. A clean move stays clean.
// No move becomes deeper, buried or uncertain.

namespace gouge {

/// Returns whether a motion with verdict `before` may become one with verdict `after`.
///
/// Ensures  It is true only in three cases: `after` is clean; it is near and `before` was not clean; or both are gouges
///          and `after` is no deeper. Depths are compared to twice the resolution, which is the accuracy of both
///          together.
[[nodiscard]] bool is_no_worse_than(const MoveVerdict& before, const MoveVerdict& after, double resolution_mm);

/// A checked path.
struct CheckedPath {
  const Toolpath* path = nullptr;
  const CheckResult* result = nullptr;
};

/// The moves [first, last) of the changed path that replaced a move of the original path: inserted ones, then its own.
struct MovesAfter {
  std::size_t first = 0, last = 0;
};

/// Returns the spans for a path of `moves` moves. The last one ends at the number of moves of the changed path.
[[nodiscard]] std::vector<MovesAfter> moves_after(std::size_t moves, const std::vector<PathChange>& changes);

/// Returns the moves of the original path, in path order, for which `after` is worse than `before` or differs from
/// `changes`. An unchanged move differs if its motion is another one. If the number of moves differs, all moves are
/// returned. `options` are the options of both checks.
[[nodiscard]] std::vector<std::size_t> find_worse(const CheckedPath& before, const std::vector<PathChange>& changes,
                                                  const CheckedPath& after, const CheckOptions& options);

}  // namespace gouge
