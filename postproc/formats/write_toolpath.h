#pragma once

#include <string>

#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/language/dialect.h"

// Writes a neutral toolpath anew in a dialect, and states what the dialect cannot carry. Motions, tools, feeds
// and the names of operations are written; spindle, coolant and comments are not. To change a file and keep
// the rest of its bytes there is write_corrected.h.

namespace gouge {

struct WrittenToolpath {
  std::string bytes;
  Diagnostics notes;  ///< losses and changes: codes convert-...
};

/// Writes lengths in the unit of `path`, and positions in part coordinates. Digits are those of the dialect, or of the
/// source file where it has more. Arcs and splines that the dialect cannot state become chords within kChordError_mm.
///
/// Ensures  The bytes, read again, hold the same motions to the last digit written. Where they do not, a note states
///          so.
/// Errors   (1) convert-not-understood: the path holds motions that are not understood, so that no dialect can hold
///          them. (2) convert-dialect: `target` is read only (Mastercam NCI), or has no tool axis (CLT) and the path
///          needs one.
/// Cost     One pass to write and one to read.
[[nodiscard]] Result<WrittenToolpath> write_toolpath(const Toolpath& path, const Dialect& target);

inline constexpr double kChordError_mm = 0.001;

}  // namespace gouge
