#pragma once

#include <iosfwd>

#include "cli/commands/compare_command.h"

namespace gouge {

/// Runs `gougecheck compare --paths`, which measures how far two readings of a toolpath are apart, such as CL data and the
/// program that a post-processor made of it. Returns the exit status: 0 within --same-within, 1 farther apart, a
/// feed became a rapid, or another order. Others are 2 wrong command line, 3 unreadable or nothing to compare, 4 a path has
/// moves that are not checked, and no difference is found.
[[nodiscard]] int run_compare_paths(const CompareArguments& arguments, double same_within_mm, std::ostream& out,
                                    std::ostream& err);

}  // namespace gouge
