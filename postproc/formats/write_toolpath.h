#pragma once

#include <string>

#include "lib/base/result.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/language/dialect.h"

// Writes a neutral toolpath as a new file in a dialect, and states what the dialect cannot express. Motions, tools,
// feeds and names of operations are written, but not spindle, coolant and comments. write_corrected.h changes a file
// and keeps the rest of its bytes.

namespace gouge {

struct WrittenToolpath {
  std::string bytes;
  Diagnostics notes;  ///< losses and changes, with codes convert-...
};

/// Writes lengths in the unit of `path`, and positions in part coordinates. The number of digits is that of the
/// dialect, or of the source file if it has more. Arcs and splines that the dialect cannot state become chords within
/// kChordError_mm.
///
/// Ensures  The bytes, read again, give the same motions to the last written digit. A note states each exception.
/// Errors   (1) convert-not-understood: the path has motions that are not understood, so no dialect can express them.
///          (2) convert-dialect: `target` is read only (Mastercam NCI), or has no tool axis (CLT) and the path needs
///          one. (3) convert-joints: a rotary joint of a program turns by more than half a turn in a move, or without tool
///          centre point control.
/// Cost     One pass to write and one to read.
[[nodiscard]] Result<WrittenToolpath> write_toolpath(const Toolpath& path, const Dialect& target);

inline constexpr double kChordError_mm = 0.001;

}  // namespace gouge
