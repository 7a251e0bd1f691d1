#pragma once

#include "lib/base/diagnostic.h"

// What the system does to a program whose outputs end before it does.

namespace gouge {

/// To be called once, first of all. A pipe without a reader and a file beyond the limit of the shell (ulimit
/// -f) become failed writes instead of the end of the program, and a standard stream that is closed (>&-) is
/// never taken by a file that is opened later: writing to it fails.
void prepare_standard_streams();

/// Whether standard output is a pipe that nobody reads any more, as in `gougecheck check ... | head -1`.
[[nodiscard]] bool is_reader_gone();

/// After a write to standard output failed. Code: output-unwritable.
[[nodiscard]] Diagnostic describe_failed_output();

}  // namespace gouge
