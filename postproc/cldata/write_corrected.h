#pragma once

#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// The toolpath's file with `changes` made, in its own dialect, frame, unit and way of writing numbers.
///
/// Requires `path` as read by read_toolpath. Unit axes, finite numbers.
/// Ensures  (1) Without changes the bytes are those of the file. (2) Statements that need no change are
///              byte-identical. (3) Read again, the file has the changed positions (rounded to the file's
///              decimals, to at least 4 in mm and 5 in inch files), inserted ones as moves of their own of
///              the same kind, tool and operation, and all other moves as before. (4) A straightened arc or
///              spline is the file's own straight positions instead; the statement that described it is gone.
/// Errors   write-move (no such move, or one named twice), write-arc (a cycle cannot be changed, an arc or spline only
///          straightened, all positions of one statement together, and no arc or spline that stays begins
///          at a position that moves), write-alone (positions before a move that has no start), write-axis (a
///          tilted position where a Mastercam NCI file cannot say one).
/// Cost     One pass over the file, and one to read it again: memory beyond `path` is about 5 times a usual file.
[[nodiscard]] Result<std::string> write_corrected(const Toolpath& path,
                                                  const std::vector<PathChange>& changes);

}  // namespace gouge
