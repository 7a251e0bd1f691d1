#pragma once

#include <iosfwd>

#include "cli/options/batch_options.h"

namespace gouge {

/// Runs `gougecheck batch`. Returns the exit status: that of the worst job.
[[nodiscard]] int run_batch(const BatchArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
