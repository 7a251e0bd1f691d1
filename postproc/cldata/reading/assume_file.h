#pragma once

#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/interpreting/file_facts.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/reading/unit_guess.h"

namespace gouge {

/// Returns the facts on which a verdict on `path` rests, as far as its file decides them: unit, dialect, completeness,
/// statements and frame. Requires a path that was read to the end. `is_dialect_given`: the user names the dialect.
[[nodiscard]] Assumptions assume_file(const Toolpath& path, const UnitGuess& unit, const Dialect& dialect,
                                      bool is_dialect_given, const FileFacts& facts);

}  // namespace gouge
