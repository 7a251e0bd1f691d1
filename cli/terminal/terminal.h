#pragma once

#include <iosfwd>
#include <string_view>

// What a stream is connected to, and whether colours go there. The answer is kept with the stream, so that whoever
// prints needs nothing but the stream.

namespace gouge {

/// Whether `stream` is standard output or standard error and these are a terminal.
[[nodiscard]] bool is_terminal(const std::ostream& stream);

/// --color: `word` is auto, always or never. Auto: on a terminal, unless the environment has NO_COLOR with a value
/// (no-color.org) or says TERM=dumb.
void choose_colour(std::ostream& stream, std::string_view word);

/// Whether text for people on `stream` is coloured; not where nothing was chosen.
[[nodiscard]] bool is_coloured(std::ostream& stream);

}  // namespace gouge
