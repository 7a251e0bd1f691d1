#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/json/json_lines.h"

// Reads all JSON input of the program. Input that needs memory or time out of proportion to its size is rejected before
// any of it is stored.

namespace gouge {

inline constexpr std::size_t kDeepestJson = 64;         ///< maximum nesting of objects and lists
inline constexpr std::size_t kLongestText = 1'000'000;  ///< maximum number of bytes of one text or key
inline constexpr std::size_t kLongestNumber = 1'000;    ///< maximum number of characters of one number

struct JsonFile {
  nlohmann::json root;
  JsonLines lines;
};

/// The expected content of a file ("a tool library"), and the codes of its errors.
struct JsonKind {
  std::string syntax_code;         ///< the text is not JSON, or a number exceeds double precision
  std::string duplicate_key_code;  ///< an object has the same key twice
  std::string what;
};

/// Reads `bytes`, with or without a byte order mark. `file` is used only in messages. Time and memory grow with the
/// size of the text. Errors, with the line: json-too-deep, json-too-long, and the codes of `kind`.
[[nodiscard]] Result<JsonFile> parse_json(const std::string& file, std::string_view bytes, const JsonKind& kind);

}  // namespace gouge
