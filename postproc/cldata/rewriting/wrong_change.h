#pragma once

#include <optional>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// What is wrong with a list of changes whatever the file's statements are: a move named twice, changes that exclude
/// each other, arcs where the dialect cannot rewrite any. Nothing: write_corrected may look at the statements.
/// Errors   write-move, write-arc, write-alone, as write_corrected.
[[nodiscard]] std::optional<Diagnostic> find_wrong_change(const Toolpath& path, const std::vector<PathChange>& changes);

}  // namespace gouge
