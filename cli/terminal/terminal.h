#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>

#include "lib/base/diagnostic.h"

// Properties of output streams: terminal or not, and colours. They are stored with the stream, so that code which
// prints needs only the stream.

// Functions for a program whose outputs end before it does.

namespace gouge {

/// Returns whether `stream` is standard output or standard error and these are a terminal.
[[nodiscard]] bool is_terminal(const std::ostream& stream);

/// Returns the width of the terminal; 0: `stream` is none, or its width is not known.
[[nodiscard]] std::size_t terminal_columns(const std::ostream& stream);

/// Applies --color to a stream; `word` is auto, always or never. Auto means colours on a terminal, unless the
/// environment has NO_COLOR with a value (no-color.org) or TERM=dumb.
void choose_colour(std::ostream& stream, std::string_view word);

/// Returns whether printed text on `stream` is coloured; false if choose_colour was not called for it.
[[nodiscard]] bool is_coloured(std::ostream& stream);

/// Prepares the standard streams; must be called once, before all else. Then a pipe without a reader, or a file beyond
/// the limit of the shell (ulimit -f), causes failed writes. It does not end the program. A file that is opened later
/// never takes the number of a closed standard stream (>&-). A write to such a stream fails.
void prepare_standard_streams();

/// Returns whether standard output is a pipe without a reader, as in `gougecheck check ... | head -1`.
[[nodiscard]] bool is_reader_gone();

/// Describes a failed write to standard output. Code: output-unwritable.
[[nodiscard]] Diagnostic describe_failed_output();

}  // namespace gouge
