#pragma once

#include <optional>

#include "lib/base/diagnostic.h"
#include "lib/check/path_fit.h"

namespace gouge {

/// What to report about a path that plainly does not fit its part, as a warning; nothing where it fits.
[[nodiscard]] std::optional<Diagnostic> describe_misfit(const Toolpath& path, const PathFit& fit);

/// True where correcting would be of no use: the whole path is wrong, not some of its positions.
[[nodiscard]] bool is_beyond_correction(const PathFit& fit);

}  // namespace gouge
