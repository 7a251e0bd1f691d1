#pragma once

#include <iosfwd>

namespace gouge {

/// Runs the whole command line: parses it, runs the command requested, and returns its exit status
/// (lib/base/exit_code.h). Prints only to `out` (results) and `err` (errors, progress).
[[nodiscard]] int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace gouge
