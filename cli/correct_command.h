#pragma once

#include <iosfwd>

#include "cli/correct_options.h"

namespace gouge {

/// `gougecheck correct`. Returns the exit status.
[[nodiscard]] int run_correct(const CorrectArguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace gouge
