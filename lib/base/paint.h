#pragma once

#include <string>
#include <string_view>

#include "lib/base/diagnostic.h"

namespace gouge {

/// The role of a stretch of text on a terminal, which selects its colour.
enum class Paint { place, error, warning, note, clean, faint };

/// Returns `text` between escape sequences that a terminal shows as colour or weight (ECMA-48, SGR). The text stays as
/// it is where `is_on` is false or it is empty. To be called after printable(), which would spell the sequences out.
[[nodiscard]] std::string painted(std::string_view text, Paint paint, bool is_on);

/// Returns to_text of a diagnostic, with its place, its severity and its code in colour.
[[nodiscard]] std::string painted_text(const Diagnostic& diagnostic);

}  // namespace gouge
