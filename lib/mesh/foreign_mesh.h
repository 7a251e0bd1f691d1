#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gouge {

/// What `bytes` are, as the rest of a sentence that begins with "the file" ("is STEP, ..."), where they are certainly
/// no STL but something that people take for a mesh. Nothing for anything else: the header of a binary STL may hold any
/// words, so only `is_text`, no control characters at the beginning, lets words count. Looks at the first lines only.
[[nodiscard]] std::optional<std::string> describe_foreign_mesh(std::string_view bytes, bool is_text);

}  // namespace gouge
