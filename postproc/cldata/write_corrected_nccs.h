#pragma once

#include <string>
#include <vector>

#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// write_corrected for a binary NCCS file: changed numbers are put into their records; where positions are
/// inserted the records are laid out in blocks anew. Requires changes that write_corrected has checked.
/// Ensures  Without insertions every byte of other numbers stays, the padding and what follows FINI too.
[[nodiscard]] std::string write_corrected_nccs(const Toolpath& path, const std::vector<PathChange>& changes);

}  // namespace gouge
