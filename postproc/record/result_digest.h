#pragma once

#include <string>
#include <string_view>

// The digest at the end of a result file, which shows whether its bytes were changed after they were written.

namespace gouge {

/// Adds the digest as the last key. Requires a JSON object that ends in "\n}\n".
[[nodiscard]] std::string with_digest(std::string json);

/// Result of the comparison of the digest at the end of a result with the bytes before it.
enum class DigestState { right, wrong, missing };
[[nodiscard]] DigestState check_digest(std::string_view json);

}  // namespace gouge
