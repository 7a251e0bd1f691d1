#pragma once

#include <iosfwd>
#include <string>

#include "cli/commands/compare_command.h"

namespace gouge {

/// Runs `gougecheck compare` of the folders of two batches, job by job. Returns the exit status: 0 no gouge is new or
/// deeper, 1 some is, 2 wrong command line, 3 unreadable, 4 something is no longer checked, 5 output unwritable.
[[nodiscard]] int run_compare_batches(const CompareArguments& arguments, double same_within_mm, std::ostream& out,
                                      std::ostream& err);

}  // namespace gouge
