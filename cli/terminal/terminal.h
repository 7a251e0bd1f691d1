#pragma once

#include <iosfwd>
#include <string_view>

#include "lib/base/diagnostic.h"

// Properties of output streams: terminal or not, and colours. They are stored with the stream, so that code that
// prints needs nothing but the stream.

// Sets how the system treats a program whose outputs end before it does.

namespace gouge {

/// Returns whether `stream` is standard output or standard error and these are a terminal.
[[nodiscard]] bool is_terminal(const std::ostream& stream);

/// --color: `word` is auto, always or never. Auto: on a terminal, unless the environment has NO_COLOR with a value
/// (no-color.org) or states TERM=dumb.
void choose_colour(std::ostream& stream, std::string_view word);

/// Returns whether text for people on `stream` is coloured; not where nothing was chosen.
[[nodiscard]] bool is_coloured(std::ostream& stream);

/// Prepares the standard streams; to be called once, first of all. A pipe without a reader and a file beyond the limit
/// of the shell (ulimit -f) then become failed writes. They do not end the program. A standard stream that is closed
/// (>&-) is never taken by a file that is opened later. A write to it fails.
void prepare_standard_streams();

/// Returns whether standard output is a pipe without a reader, as in `gougecheck check ... | head -1`.
[[nodiscard]] bool is_reader_gone();

/// Describes a failed write to standard output. Code: output-unwritable.
[[nodiscard]] Diagnostic describe_failed_output();

}  // namespace gouge
