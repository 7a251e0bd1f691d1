#pragma once

#include <string>
#include <string_view>

#include "lib/base/diagnostic.h"

namespace gouge {

/// The role of a stretch of text on a terminal, which selects its colour.
enum class Paint { place, error, warning, note, clean, faint };

/// Returns `text` between escape sequences that a terminal shows as colour or weight (ECMA-48, SGR). Returns the text
/// unchanged if `is_on` is false or the text is empty. Call it after printable(), which would escape the sequences.
[[nodiscard]] std::string painted(std::string_view text, Paint paint, bool is_on);

/// Returns to_text of a diagnostic, with its place, severity and code in colour.
[[nodiscard]] std::string painted_text(const Diagnostic& diagnostic);

}  // namespace gouge
