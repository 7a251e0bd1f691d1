#pragma once

#include <string>
#include <vector>

#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

// Rules that a correction must keep, by the checks of the path before and after it. A clean move stays clean. No move
// becomes deeper, buried or uncertain.

namespace gouge {

/// Returns whether a motion with verdict `before` may become one with verdict `after`.
///
/// Ensures  True only in three cases: `after` is clean; it is near and `before` was not clean; or both are gouges and
///          `after` is no deeper. Depths are compared to twice the resolution, as that is how far both are known.
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

/// Returns moves of the path as it was, in path order, of which `after` is worse than `before` or differs from
/// `changes`. An unchanged move differs when its motion is another one. Where the number of moves differs, all moves
/// are returned. The `options` are those of both checks.
[[nodiscard]] std::vector<std::size_t> find_worse(const CheckedPath& before, const std::vector<PathChange>& changes,
                                                  const CheckedPath& after, const CheckOptions& options);

}  // namespace gouge
