#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"

namespace gouge {

/// Writes the outputs of a command line that can state an `error`, such as --junit and --sarif. Does nothing for a command
/// other than `check` and `correct`, for a wrong command line, and if an output would replace an input. `words` is the whole
/// command line, beginning with the program's name. Required options may be missing.
void write_failure_of(const std::vector<std::string>& words, const Diagnostic& error, int status, std::ostream& out,
                      std::ostream& err);

/// Prints an error that ends a command before its job begins, and writes the outputs that can state it. Returns the exit
/// status.
[[nodiscard]] int fail_line(const std::vector<std::string>& words, const Diagnostic& error, std::ostream& out,
                            std::ostream& err);

}  // namespace gouge
