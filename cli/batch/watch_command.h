#pragma once

#include <iosfwd>

#include "cli/options/batch_options.h"

namespace gouge {

/// Runs `gougecheck batch --watch`: checks the toolpaths of a hot folder until a signal ends it. Returns the exit status
/// of the last run, if an error ends it.
[[nodiscard]] int run_watch(const BatchArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
